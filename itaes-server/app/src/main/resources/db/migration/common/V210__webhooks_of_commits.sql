-- Webhooks that exist were created for builds, and keep it so.
ALTER TABLE webhook ADD COLUMN events VARCHAR(200) DEFAULT 'build.finished' NOT NULL;

ALTER TABLE webhook_delivery ADD COLUMN event VARCHAR(20) DEFAULT 'build.finished' NOT NULL;
-- Either a build or a commit.
ALTER TABLE webhook_delivery ALTER COLUMN build_id DROP NOT NULL;
ALTER TABLE webhook_delivery ADD COLUMN commit_id VARCHAR(36);
ALTER TABLE webhook_delivery ADD CONSTRAINT webhook_delivery_commit
  FOREIGN KEY (commit_id) REFERENCES git_commit (id) ON DELETE CASCADE;
ALTER TABLE webhook_delivery ADD CONSTRAINT webhook_delivery_of_commit
  UNIQUE (webhook_id, commit_id, event);
-- Null until it is sent for the first time: comparing the values of a commit takes a while.
ALTER TABLE webhook_delivery ALTER COLUMN payload DROP NOT NULL;
