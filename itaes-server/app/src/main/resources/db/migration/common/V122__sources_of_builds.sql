-- What a build was made of, as its requester says; both are null if nothing was said.
ALTER TABLE build ADD COLUMN commit_id VARCHAR(100);
-- Lines KEY=VALUE.
ALTER TABLE build ADD COLUMN build_labels VARCHAR(8000);
CREATE INDEX build_by_commit ON build (activity_id, commit_id);
