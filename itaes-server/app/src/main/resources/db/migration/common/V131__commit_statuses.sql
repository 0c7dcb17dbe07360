-- The forge that hears of commits, and whose messages are accepted.
ALTER TABLE git_source ADD COLUMN forge VARCHAR(10) DEFAULT 'NONE' NOT NULL;
ALTER TABLE git_source ADD COLUMN api_url VARCHAR(2000);
ALTER TABLE git_source ADD COLUMN project VARCHAR(400);
-- Encrypted; null to use the token of the repository.
ALTER TABLE git_source ADD COLUMN forge_secret VARCHAR(30000);
-- Encrypted; signs the forge's messages.
ALTER TABLE git_source ADD COLUMN hook_secret VARCHAR(1000);

-- Statuses to send, written in the transaction that changes the commit: each is sent until the
-- forge has it.
CREATE TABLE git_status (
  id          VARCHAR(36)   PRIMARY KEY,
  commit_id   VARCHAR(36)   NOT NULL REFERENCES git_commit (id) ON DELETE CASCADE,
  is_final    BOOLEAN       NOT NULL,
  result      VARCHAR(10)   NOT NULL,
  description VARCHAR(200)  NOT NULL,
  state       VARCHAR(20)   NOT NULL,
  tries       INTEGER       NOT NULL,
  due         TIMESTAMP WITH TIME ZONE NOT NULL,
  created     TIMESTAMP WITH TIME ZONE NOT NULL,
  last_answer VARCHAR(400),
  UNIQUE (commit_id, is_final)
);
CREATE INDEX git_status_by_due ON git_status (state, due);

-- Messages that were accepted, so that a repeated one does nothing.
CREATE TABLE git_hook_delivery (
  source_id VARCHAR(36)  NOT NULL REFERENCES git_source (id) ON DELETE CASCADE,
  delivery  VARCHAR(200) NOT NULL,
  received  TIMESTAMP WITH TIME ZONE NOT NULL,
  PRIMARY KEY (source_id, delivery)
);
