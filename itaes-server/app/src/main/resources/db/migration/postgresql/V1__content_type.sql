-- Bytes of any length; the two databases name the type differently, so that every later migration can be shared.
CREATE DOMAIN CONTENT AS BYTEA;
