-- The signals of a case that its trajectory conditions use, as gzipped JSON.
CREATE TABLE case_signals (
  token    BIGINT      NOT NULL REFERENCES attempt (token) ON DELETE CASCADE,
  case_no  INTEGER     NOT NULL,
  sha256   VARCHAR(64) NOT NULL REFERENCES file_content (sha256),
  size     BIGINT      NOT NULL,
  PRIMARY KEY (token, case_no)
);
-- To find contents that nothing refers to.
CREATE INDEX case_signals_by_content ON case_signals (sha256);
