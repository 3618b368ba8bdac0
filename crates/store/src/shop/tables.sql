-- Version 1: what is kept, and what keeps it. Later versions only add.
CREATE TABLE fitcheck.meta (
    one boolean PRIMARY KEY DEFAULT true CHECK (one),
    version integer NOT NULL,
    made timestamptz NOT NULL DEFAULT pg_catalog.clock_timestamp()
);

-- Whose chain it is: the login that begins one is the only one that adds to it.
CREATE TABLE fitcheck.chain (
    chain bytea PRIMARY KEY CHECK (octet_length(chain) = 16),
    login name NOT NULL DEFAULT session_user,
    begun timestamptz NOT NULL DEFAULT pg_catalog.clock_timestamp()
);

-- The body is text, byte for byte as it was hashed: jsonb would keep another one.
CREATE TABLE fitcheck.entry (
    chain bytea NOT NULL REFERENCES fitcheck.chain,
    number bigint NOT NULL CHECK (0 < number),
    station text NOT NULL CHECK (octet_length(station) <= 1024),
    hash bytea NOT NULL CHECK (octet_length(hash) = 32),
    body text NOT NULL CHECK (octet_length(body) <= 16777216),
    received timestamptz NOT NULL DEFAULT pg_catalog.clock_timestamp(),
    PRIMARY KEY (chain, number)
);
CREATE INDEX entry_received ON fitcheck.entry (received DESC, chain, number DESC);

CREATE FUNCTION fitcheck.refuse() RETURNS trigger
LANGUAGE plpgsql SET search_path = fitcheck, pg_temp AS $$
BEGIN
    RAISE EXCEPTION 'a journal is only added to' USING ERRCODE = 'insufficient_privilege';
END
$$;
CREATE TRIGGER entry_keeps BEFORE UPDATE OR DELETE ON fitcheck.entry FOR EACH STATEMENT EXECUTE FUNCTION fitcheck.refuse();
CREATE TRIGGER entry_stays BEFORE TRUNCATE ON fitcheck.entry FOR EACH STATEMENT EXECUTE FUNCTION fitcheck.refuse();
CREATE TRIGGER chain_stays BEFORE DELETE OR TRUNCATE ON fitcheck.chain FOR EACH STATEMENT EXECUTE FUNCTION fitcheck.refuse();
-- For replicas and their like, too.
ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_keeps;
ALTER TABLE fitcheck.entry ENABLE ALWAYS TRIGGER entry_stays;
ALTER TABLE fitcheck.chain ENABLE ALWAYS TRIGGER chain_stays;

-- Every entry that is added is hashed over the one before: once a statement, for all of its entries.
CREATE FUNCTION fitcheck.follow() RETURNS trigger
LANGUAGE plpgsql SET search_path = fitcheck, pg_temp AS $$
DECLARE
    odd bigint;
BEGIN
    SELECT added.number INTO odd
    FROM added LEFT JOIN fitcheck.entry AS before ON before.chain = added.chain AND before.number = added.number - 1
    WHERE (before.number IS NULL AND added.number <> 1)
       OR added.hash IS DISTINCT FROM sha256(
            convert_to('fitcheck entry 1', 'UTF8') || '\x00'::bytea
            || coalesce(before.hash, decode(repeat('00', 32), 'hex'))
            || int4send(octet_length(added.chain)) || added.chain
            || int8send(added.number)
            || int4send(octet_length(added.body)) || convert_to(added.body, 'UTF8'))
    ORDER BY added.number LIMIT 1;
    IF FOUND THEN
        RAISE EXCEPTION 'entry % does not follow the one before it', odd USING ERRCODE = 'integrity_constraint_violation';
    END IF;
    RETURN NULL;
END
$$;
CREATE TRIGGER entry_follows AFTER INSERT ON fitcheck.entry REFERENCING NEW TABLE AS added
    FOR EACH STATEMENT EXECUTE FUNCTION fitcheck.follow();

-- A station adds to its own chains alone. Everybody who may read at all reads everything.
ALTER TABLE fitcheck.chain ENABLE ROW LEVEL SECURITY;
CREATE POLICY chain_is_read ON fitcheck.chain FOR SELECT USING (true);
CREATE POLICY chain_is_own ON fitcheck.chain FOR INSERT WITH CHECK (login = session_user);
ALTER TABLE fitcheck.entry ENABLE ROW LEVEL SECURITY;
CREATE POLICY entry_is_read ON fitcheck.entry FOR SELECT USING (true);
CREATE POLICY entry_is_own ON fitcheck.entry FOR INSERT WITH CHECK (EXISTS (
    SELECT FROM fitcheck.chain WHERE chain.chain = entry.chain AND chain.login = session_user));

GRANT USAGE ON SCHEMA fitcheck TO fitcheck_station, fitcheck_reader;
GRANT SELECT ON fitcheck.meta, fitcheck.chain, fitcheck.entry TO fitcheck_station, fitcheck_reader;
GRANT INSERT (chain) ON fitcheck.chain TO fitcheck_station;
GRANT INSERT (chain, number, station, hash, body) ON fitcheck.entry TO fitcheck_station;
