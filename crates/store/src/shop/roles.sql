-- Roles belong to the whole server: another database of it may have made them, at this moment too.
DO $$
DECLARE
    wanted text;
BEGIN
    FOREACH wanted IN ARRAY ARRAY['fitcheck_owner', 'fitcheck_station', 'fitcheck_reader'] LOOP
        IF NOT EXISTS (SELECT FROM pg_catalog.pg_roles WHERE rolname = wanted) THEN
            BEGIN
                EXECUTE format('CREATE ROLE %I NOLOGIN', wanted);
            EXCEPTION WHEN duplicate_object OR unique_violation THEN
                NULL;
            END;
        END IF;
    END LOOP;
    IF NOT pg_catalog.pg_has_role(current_user, 'fitcheck_owner', 'MEMBER') THEN
        EXECUTE format('GRANT fitcheck_owner TO %I', current_user);
    END IF;
END
$$;
