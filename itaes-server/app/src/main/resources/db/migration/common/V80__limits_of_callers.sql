-- A session is known by the hash of its secret, which is longer; those whose secret stands here end.
DELETE FROM spring_session_attributes;
DELETE FROM spring_session;
ALTER TABLE spring_session ALTER COLUMN session_id SET DATA TYPE VARCHAR(64);

-- Null: the server's own setting.
ALTER TABLE person ADD COLUMN quota_mib BIGINT;

-- Who stored the files of an activity last, and who requested a build: what they take counts for them.
CREATE TABLE workspace_owner (
  workspace_id VARCHAR(36) PRIMARY KEY REFERENCES workspace (id) ON DELETE CASCADE,
  person_id    VARCHAR(36) NOT NULL REFERENCES person (id) ON DELETE CASCADE
);
CREATE INDEX workspace_owner_by_person ON workspace_owner (person_id);

CREATE TABLE suite_owner (
  suite_id  VARCHAR(36) PRIMARY KEY REFERENCES suite (id) ON DELETE CASCADE,
  person_id VARCHAR(36) NOT NULL REFERENCES person (id) ON DELETE CASCADE,
  -- Of its document, in bytes.
  size      BIGINT      NOT NULL
);
CREATE INDEX suite_owner_by_person ON suite_owner (person_id);

CREATE TABLE build_owner (
  build_id  VARCHAR(36) PRIMARY KEY REFERENCES build (id) ON DELETE CASCADE,
  person_id VARCHAR(36) NOT NULL REFERENCES person (id) ON DELETE CASCADE
);
CREATE INDEX build_owner_by_person ON build_owner (person_id);

-- A method of many parameters is longer than 400 characters.
ALTER TABLE workspace_method ALTER COLUMN method SET DATA TYPE VARCHAR(4000);
