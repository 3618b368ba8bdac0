-- What a schema is made of, one row a thing: its kind, its name, and what it says. {schema} is the schema, {owner} whose it has to be.
-- Names of schemas are taken off, so that a schema and its copy under another name say the same.
WITH one AS (SELECT {schema} AS oid, {owner}::name AS owner),
relation AS (
    SELECT c.*, pg_get_userbyid(c.relowner) = one.owner AS is_owned, one.owner
    FROM pg_class AS c, one WHERE c.relnamespace = one.oid AND c.relkind IN ('r', 'v', 'm', 'p', 'f', 'S')
),
thing(kind, name, says) AS (
    SELECT 'table', relname::text, concat_ws(' ', relkind, relpersistence IN ('p', {persistence}), relispartition, relforcerowsecurity, reloptions)
    FROM relation WHERE relkind <> 'v'
    UNION ALL
    SELECT 'view', relname::text, concat_ws(' ', reloptions, pg_get_viewdef(oid)) FROM relation WHERE relkind = 'v'
    UNION ALL
    SELECT 'table', relname || '.' || attname, concat_ws(' ', format_type(atttypid, atttypmod), attnotnull, attidentity, attgenerated,
        attcollation, (SELECT pg_get_expr(adbin, adrelid) FROM pg_attrdef WHERE adrelid = attrelid AND adnum = attnum))
    FROM relation JOIN pg_attribute ON attrelid = relation.oid AND 0 < attnum AND NOT attisdropped WHERE relkind <> 'v'
    UNION ALL
    SELECT 'table', conname::text, concat_ws(' ', relname, convalidated, pg_get_constraintdef(pg_constraint.oid))
    FROM relation JOIN pg_constraint ON conrelid = relation.oid
    UNION ALL
    SELECT 'table', relname::text, 'inherited by ' || inhrelid::regclass FROM relation JOIN pg_inherits ON inhparent = relation.oid
    UNION ALL
    SELECT 'index', i.relname::text, concat_ws(' ', indisvalid, indisready, indislive, pg_get_indexdef(indexrelid))
    FROM relation JOIN pg_index ON indrelid = relation.oid JOIN pg_class AS i ON i.oid = indexrelid
    UNION ALL
    SELECT 'trigger', tgname::text, concat_ws(' ', tgenabled, pg_get_triggerdef(pg_trigger.oid))
    FROM relation JOIN pg_trigger ON tgrelid = relation.oid WHERE NOT tgisinternal
    UNION ALL
    -- Those of foreign keys have names by chance.
    SELECT 'trigger', relname::text, string_agg(concat_ws(' ', tgtype, tgenabled), ', ' ORDER BY tgtype, tgenabled)
    FROM relation JOIN pg_trigger ON tgrelid = relation.oid WHERE tgisinternal GROUP BY relname
    UNION ALL
    SELECT 'rule', rulename::text, pg_get_ruledef(pg_rewrite.oid) FROM relation JOIN pg_rewrite ON ev_class = relation.oid
    WHERE rulename <> '_RETURN'
    UNION ALL
    SELECT 'policy', polname::text, concat_ws(' ', relname, polcmd, polpermissive,
        (SELECT string_agg(CASE role WHEN 0 THEN 'public' ELSE pg_get_userbyid(role)::text END, ',' ORDER BY role) FROM unnest(polroles) AS role),
        'USING', pg_get_expr(polqual, polrelid), 'CHECK', pg_get_expr(polwithcheck, polrelid))
    FROM relation JOIN pg_policy ON polrelid = relation.oid
    UNION ALL
    SELECT 'function', proname::text, concat_ws(' ', prokind,
        CASE WHEN prokind IN ('f', 'p') THEN pg_get_functiondef(pg_proc.oid) ELSE pg_get_function_identity_arguments(pg_proc.oid) END)
    FROM pg_proc, one WHERE pronamespace = one.oid
    UNION ALL
    SELECT 'owner', relname::text, 'is another' FROM relation WHERE NOT is_owned
    UNION ALL
    SELECT 'owner', proname::text, 'is another' FROM pg_proc, one WHERE pronamespace = one.oid AND pg_get_userbyid(proowner) <> one.owner
    UNION ALL
    SELECT 'grant', relname::text, string_agg(concat_ws(' ', role, privilege_type, is_grantable), ', ' ORDER BY role, privilege_type)
    FROM relation, aclexplode(relacl) AS acl, LATERAL (SELECT CASE acl.grantee WHEN 0 THEN 'public' ELSE pg_get_userbyid(acl.grantee)::text END) AS who(role)
    WHERE role <> owner GROUP BY relname
    UNION ALL
    SELECT 'grant', relname || '.' || attname, string_agg(concat_ws(' ', role, privilege_type, is_grantable), ', ' ORDER BY role, privilege_type)
    FROM relation JOIN pg_attribute ON attrelid = relation.oid AND 0 < attnum, aclexplode(attacl) AS acl,
        LATERAL (SELECT CASE acl.grantee WHEN 0 THEN 'public' ELSE pg_get_userbyid(acl.grantee)::text END) AS who(role)
    WHERE role <> owner GROUP BY relname, attname
    UNION ALL
    SELECT 'grant', proname::text, string_agg(concat_ws(' ', role, privilege_type, is_grantable), ', ' ORDER BY role, privilege_type)
    FROM one JOIN pg_proc ON pronamespace = one.oid, aclexplode(coalesce(proacl, acldefault('f', proowner))) AS acl,
        LATERAL (SELECT CASE acl.grantee WHEN 0 THEN 'public' ELSE pg_get_userbyid(acl.grantee)::text END) AS who(role)
    WHERE role <> owner GROUP BY proname
)
SELECT kind, name, regexp_replace(says, '\m(fitcheck|pg_temp(_[0-9]+)?)\.', '', 'g') FROM thing ORDER BY kind, name, says
