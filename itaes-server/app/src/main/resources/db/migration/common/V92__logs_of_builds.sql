-- Logs of builds, which were files before; V93 imports those.
CREATE TABLE build_log (
  build_id VARCHAR(36) NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  -- Where the chunk begins in the log, in bytes.
  start_at BIGINT      NOT NULL,
  size     INTEGER     NOT NULL,
  bytes    CONTENT     NOT NULL,
  PRIMARY KEY (build_id, start_at)
);
