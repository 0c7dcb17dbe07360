-- The recordings of the second runs of a case for the relations of its model. The recording of the case itself is in `recording`.
CREATE TABLE second_run_recording (
  token    BIGINT      NOT NULL REFERENCES attempt (token) ON DELETE CASCADE,
  case_no  INTEGER     NOT NULL,
  -- Index of the relation in the test model, from 1.
  relation INTEGER     NOT NULL,
  sha256   VARCHAR(64) NOT NULL REFERENCES file_content (sha256),
  size     BIGINT      NOT NULL,
  received TIMESTAMP WITH TIME ZONE NOT NULL,
  PRIMARY KEY (token, case_no, relation)
);
CREATE INDEX second_run_recording_by_content ON second_run_recording (sha256);
