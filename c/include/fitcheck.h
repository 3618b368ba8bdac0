/* Fitcheck for C: limits of size of ISO 286 and ISO 2768-1, and whether a measured hole or shaft is good, rework or scrap.
 *
 * Texts are UTF-8 and end with a zero byte. Lengths are whole nanometres. Nothing is kept between two calls: any thread may call at any
 * time. The library reads no file and talks to no other machine. */

#ifndef FITCHECK_H
#define FITCHECK_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of these declarations; compare it with fitcheck_version(). */
#define FITCHECK_VERSION 1

/* How a call ends. */
enum {
    FITCHECK_ANSWERED = 0,
    /* There is no answer; the text says why. */
    FITCHECK_REFUSED = 1,
    /* A pointer is null, or a text is not UTF-8. */
    FITCHECK_MISUSED = 2,
    /* A fault of this library. */
    FITCHECK_FAILED = 3
};

enum { FITCHECK_NEITHER = 0, FITCHECK_HOLE = 1, FITCHECK_SHAFT = 2 };

/* What to do with a part, best first. */
enum {
    FITCHECK_GOOD = 0,
    /* Outside, but material can still be taken off. */
    FITCHECK_REWORK = 1,
    /* Nothing is decided; not without a decision rule, so not here. */
    FITCHECK_RE_MEASURE = 2,
    /* Outside, and nobody has said hole or shaft. */
    FITCHECK_OUT_OF_LIMITS = 3,
    /* Outside, and material cannot be put back. */
    FITCHECK_SCRAP = 4
};

typedef struct FitcheckLimits {
    int64_t nominal_nm;
    int64_t minimum_nm;
    int64_t maximum_nm;
    /* FITCHECK_HOLE, FITCHECK_SHAFT or FITCHECK_NEITHER. */
    int32_t feature;
} FitcheckLimits;

typedef struct FitcheckVerdict {
    FitcheckLimits limits;
    int64_t measured_nm;
    /* Measured minus nominal size. */
    int64_t deviation_nm;
    /* For rework: what to remove from the diameter to reach the nearest limit; otherwise 0. */
    int64_t remove_nm;
    /* FITCHECK_GOOD to FITCHECK_SCRAP. Limits belong to the zone. */
    int32_t status;
    /* 1 where the text says something to look at before the status is believed. */
    int32_t look_first;
} FitcheckVerdict;

int32_t fitcheck_version(void);

/* The limits of size of a callout such as "25 H7", "12 +0.01 -0.015" or "10m".
 *
 * language: "cs", "de", "en", "es", "fr", "it", "nl" or "pl"; NULL is English.
 * text: gets where the limits come from, and on further lines what to look at; or why there is no answer. It may be NULL. What is
 * longer than capacity, the zero byte counted, is cut behind a whole character. */
int32_t fitcheck_limits(const char *callout, const char *language, FitcheckLimits *limits, char *text, size_t capacity);

/* The verdict for a measured diameter in whole nanometres, at 20 degrees Celsius. */
int32_t fitcheck_check_nm(const char *callout, int64_t measured_nm, const char *language, FitcheckVerdict *verdict,
                          char *text, size_t capacity);

/* The same for a diameter as text: "25.012" or "25,012" in millimetres, or with its unit: "984.7 µm", "0.98 in". */
int32_t fitcheck_check(const char *callout, const char *measured, const char *language, FitcheckVerdict *verdict,
                       char *text, size_t capacity);

#ifdef __cplusplus
}
#endif

#endif
