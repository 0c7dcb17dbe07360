-- What a suite was before its latest changes, so that they can be undone; only the latest few are kept.
CREATE TABLE suite_revision (
  suite_id VARCHAR(36) NOT NULL REFERENCES suite (id) ON DELETE CASCADE,
  version  BIGINT      NOT NULL,
  document CONTENT     NOT NULL,
  PRIMARY KEY (suite_id, version)
);
