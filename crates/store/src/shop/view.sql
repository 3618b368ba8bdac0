-- Made anew each time: what entries say, in plain columns. A body that is no JSON, or that a later version wrote in another way, gives
-- empty columns and never an error. A later version adds columns at the end.
CREATE OR REPLACE FUNCTION fitcheck.figures(
    body text,
    OUT kind text, OUT at timestamptz, OUT offset_min integer,
    OUT who text, OUT part text, OUT serial text, OUT feature text,
    OUT callout text, OUT class text,
    OUT min_mm numeric, OUT max_mm numeric, OUT measured_mm numeric, OUT deviation_um numeric,
    OUT rule text, OUT u_um numeric, OUT status text, OUT simulated boolean, OUT origin text,
    OUT remark text, OUT correction_of bigint
)
LANGUAGE plpgsql IMMUTABLE SET search_path = pg_catalog, pg_temp AS $$
DECLARE
    entry jsonb;
    about jsonb;
    found jsonb;
    size jsonb;
    measured jsonb;
    least jsonb;
    most jsonb;
BEGIN
    entry := body::jsonb;
    about := entry -> 'about';
    kind := entry ->> 'kind';
    at := timestamptz 'epoch' + (about #>> '{time,utc_ms}')::bigint * interval '1 millisecond';
    offset_min := (about #>> '{time,offset_min}')::integer;
    who := about ->> 'who';
    part := about ->> 'part';
    serial := about ->> 'serial';
    feature := about ->> 'feature';
    remark := about ->> 'remark';
    correction_of := coalesce(entry #>> '{check,corrects,number}', entry #>> '{withdrawal,number}')::bigint;
    found := entry -> 'check';
    IF found IS NULL THEN
        RETURN;
    END IF;
    size := found -> 'size';
    status := found ->> 'status';
    simulated := (found ->> 'simulated')::boolean;
    callout := size ->> 'callout';
    class := substring(callout FROM ' ([A-Za-z]{1,2}[0-9]{1,2})$');
    least := coalesce(size #> '{limits,min_nm}', found #> '{cycle,limits_nm,0}');
    most := coalesce(size #> '{limits,max_nm}', found #> '{cycle,limits_nm,1}');
    measured := coalesce(size #> '{measurement,diameter_nm}', found #> '{cycle,measured_nm}');
    min_mm := trim_scale((least #>> '{}')::bigint / 1000000.0);
    max_mm := trim_scale((most #>> '{}')::bigint / 1000000.0);
    measured_mm := trim_scale((measured #>> '{}')::bigint / 1000000.0);
    deviation_um := trim_scale(((measured #>> '{}')::bigint - (size #>> '{limits,nominal_nm}')::bigint) / 1000.0);
    rule := size #>> '{rule,name}';
    u_um := trim_scale((size #>> '{rule,u_pm}')::bigint / 1000000.0);
    origin := concat_ws(' ',
        coalesce(size #>> '{measurement,origin,kind}', found #>> '{cycle,origin,kind}'),
        coalesce(size #>> '{measurement,origin,file}', found #>> '{cycle,origin,file}'));
EXCEPTION WHEN others THEN
    kind := NULL; at := NULL; offset_min := NULL; who := NULL; part := NULL; serial := NULL; feature := NULL;
    callout := NULL; class := NULL; min_mm := NULL; max_mm := NULL; measured_mm := NULL; deviation_um := NULL;
    rule := NULL; u_um := NULL; status := NULL; simulated := NULL; origin := NULL; remark := NULL; correction_of := NULL;
END
$$;

-- The number of the entry that an entry corrects, or of the alarm that it answers; most do neither, and are not parsed for it.
CREATE OR REPLACE FUNCTION fitcheck.corrects(body text) RETURNS bigint
LANGUAGE plpgsql IMMUTABLE SET search_path = pg_catalog, pg_temp AS $$
DECLARE
    entry jsonb;
BEGIN
    IF strpos(body, '"corrects":{') = 0 AND strpos(body, '"withdrawal":{') = 0 AND strpos(body, '"answers":{') = 0 THEN
        RETURN NULL;
    END IF;
    entry := body::jsonb;
    RETURN coalesce(entry #>> '{check,corrects,number}', entry #>> '{withdrawal,number}', entry #>> '{alarm,answers,number}')::bigint;
EXCEPTION WHEN others THEN
    RETURN NULL;
END
$$;
CREATE INDEX IF NOT EXISTS entry_corrects ON fitcheck.entry (chain, fitcheck.corrects(body)) WHERE fitcheck.corrects(body) IS NOT NULL;
-- An older program has said less of what an entry corrects.
REINDEX INDEX fitcheck.entry_corrects;

-- The newest entry that corrects another one. Without OFFSET the newest entries of the chain would be searched one by one.
CREATE OR REPLACE FUNCTION fitcheck.corrected_by(of bytea, wanted bigint) RETURNS bigint
LANGUAGE sql STABLE SET search_path = pg_catalog, pg_temp AS $$
    SELECT max(number) FROM (
        SELECT number FROM fitcheck.entry WHERE chain = of AND fitcheck.corrects(body) = wanted OFFSET 0) AS correcting
$$;

-- One row a check, for spreadsheets and dashboards. Entries that cannot be read are there, too, without figures.
CREATE OR REPLACE VIEW fitcheck.checks AS
SELECT
    entry.station, entry.number, entry.received,
    figures.at, figures.offset_min, figures.who, figures.part, figures.serial, figures.feature,
    figures.callout, figures.class, figures.min_mm, figures.max_mm, figures.measured_mm, figures.deviation_um,
    figures.rule, figures.u_um, figures.status, figures.simulated, figures.origin, figures.remark,
    figures.correction_of,
    fitcheck.corrected_by(entry.chain, entry.number) AS corrected_by,
    round(extract(epoch FROM entry.received - figures.at)::numeric, 3) AS clock_difference_s,
    encode(entry.hash, 'hex') AS hash,
    encode(entry.chain, 'hex') AS chain,
    (SELECT login FROM fitcheck.chain WHERE chain.chain = entry.chain) AS login
FROM fitcheck.entry AS entry CROSS JOIN LATERAL fitcheck.figures(entry.body) AS figures
WHERE figures.kind = 'check' OR figures.kind IS NULL;

GRANT SELECT ON fitcheck.checks TO fitcheck_station, fitcheck_reader;
