-- Documents are apart from what lists show, so that a list reads none of them.
CREATE TABLE suite_document (
  suite_id VARCHAR(36) PRIMARY KEY REFERENCES suite (id) ON DELETE CASCADE,
  document CONTENT     NOT NULL
);
INSERT INTO suite_document (suite_id, document) SELECT id, document FROM suite;
ALTER TABLE suite DROP COLUMN document;

ALTER TABLE suite ADD COLUMN updated TIMESTAMP WITH TIME ZONE;
UPDATE suite SET updated = created;
ALTER TABLE suite ALTER COLUMN updated SET NOT NULL;

-- Filled from the documents by V91.
CREATE TABLE suite_parameter (
  suite_id  VARCHAR(36) NOT NULL REFERENCES suite (id) ON DELETE CASCADE,
  position  INTEGER     NOT NULL,
  name      VARCHAR     NOT NULL,
  kind      VARCHAR(20) NOT NULL,
  real_type VARCHAR     NOT NULL,
  PRIMARY KEY (suite_id, position)
);
