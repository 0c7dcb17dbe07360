-- Of which cases of a build it is recorded what moved, and of the builds of a schedule where somebody said so.
ALTER TABLE build ADD COLUMN recorded_cases VARCHAR(10) NOT NULL DEFAULT 'NONE';
ALTER TABLE schedule ADD COLUMN recorded_cases VARCHAR(10);

-- What moved in a case, as the attempt saw it.
CREATE TABLE recording (
  token    BIGINT      NOT NULL REFERENCES attempt (token) ON DELETE CASCADE,
  case_no  INTEGER     NOT NULL,
  sha256   VARCHAR(64) NOT NULL REFERENCES file_content (sha256),
  size     BIGINT      NOT NULL,
  received TIMESTAMP WITH TIME ZONE NOT NULL,
  PRIMARY KEY (token, case_no)
);
-- To find contents that nothing refers to.
CREATE INDEX recording_by_content ON recording (sha256);
