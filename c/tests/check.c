/* Limits and verdicts through the header, as a program in C has them. */

#include "fitcheck.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int failed = 0;

static void expect(int holds, const char *what) {
    if (!holds) {
        fprintf(stderr, "does not hold: %s\n", what);
        failed = 1;
    }
}

int main(void) {
    FitcheckLimits limits;
    FitcheckVerdict verdict;
    char text[256];

    expect(fitcheck_version() == FITCHECK_VERSION, "header and library have one version");

    /* ISO 286-2: 25 H7 is 0/+21 um, 50 p6 is +26/+42 um. */
    expect(fitcheck_limits("25 H7", NULL, &limits, text, sizeof text) == FITCHECK_ANSWERED, "25 H7 is answered");
    expect(limits.nominal_nm == 25000000 && limits.minimum_nm == 25000000 && limits.maximum_nm == 25021000, "25 H7");
    expect(limits.feature == FITCHECK_HOLE, "25 H7 is a hole");
    expect(strstr(text, "ISO 286") != NULL, "the source is said");
    expect(fitcheck_limits("50 p6", "nl", &limits, NULL, 0) == FITCHECK_ANSWERED, "without a text");
    expect(limits.minimum_nm == 50026000 && limits.maximum_nm == 50042000 && limits.feature == FITCHECK_SHAFT, "50 p6");

    expect(fitcheck_check_nm("25 H7", 25021000, NULL, &verdict, text, sizeof text) == FITCHECK_ANSWERED, "a check");
    expect(verdict.status == FITCHECK_GOOD && !verdict.look_first, "a limit belongs to the zone");
    fitcheck_check_nm("25 H7", 25021001, NULL, &verdict, text, sizeof text);
    expect(verdict.status == FITCHECK_SCRAP, "a nanometre beyond it does not");
    fitcheck_check("25 H7", "24,9915", NULL, &verdict, text, sizeof text);
    expect(verdict.status == FITCHECK_REWORK && verdict.remove_nm == 8500 && verdict.deviation_nm == -8500, "rework");
    fitcheck_check("12 \xc2\xb1" "0.02", "12.03", NULL, &verdict, text, sizeof text);
    expect(verdict.status == FITCHECK_OUT_OF_LIMITS, "neither hole nor shaft");
    expect(fitcheck_check("25 H7", "0.985", NULL, &verdict, text, sizeof text) == FITCHECK_ANSWERED, "far off");
    expect(verdict.look_first == 1 && strchr(text, '\n') != NULL, "what is far off is never silent");

    fitcheck_check("25 H7 \xe2\x92\xba", "25.012", NULL, &verdict, text, sizeof text);
    expect(verdict.status == FITCHECK_GOOD && verdict.look_first == 1, "one diameter leaves an envelope open");

    expect(fitcheck_check("4000 H7", "4000", NULL, &verdict, text, sizeof text) == FITCHECK_REFUSED, "beyond ISO 286");
    expect(strstr(text, "3150") != NULL, "and why");
    expect(fitcheck_check("25 H7", "0", NULL, &verdict, text, sizeof text) == FITCHECK_REFUSED, "zero is no diameter");
    expect(fitcheck_check("25 H7", "", "de", &verdict, text, sizeof text) == FITCHECK_REFUSED, "nor is nothing");
    expect(fitcheck_check_nm("25 H7", INT64_MIN, NULL, &verdict, text, sizeof text) == FITCHECK_REFUSED, "nor this");
    expect(fitcheck_check("4000 H7", "4000", NULL, &verdict, text, 5) == FITCHECK_REFUSED, "with little room");
    expect(strlen(text) <= 4, "the text is cut");

    expect(fitcheck_limits(NULL, NULL, &limits, text, sizeof text) == FITCHECK_MISUSED, "no callout");
    expect(fitcheck_limits("25 H7", NULL, NULL, text, sizeof text) == FITCHECK_MISUSED, "no room for limits");
    expect(fitcheck_check("25 H7", NULL, NULL, &verdict, text, sizeof text) == FITCHECK_MISUSED, "no value");
    expect(fitcheck_check("25 \xff", "25", NULL, &verdict, text, sizeof text) == FITCHECK_MISUSED, "not UTF-8");
    return failed ? EXIT_FAILURE : EXIT_SUCCESS;
}
