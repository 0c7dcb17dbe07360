-- An activity on the server has one name in the database, the code and the REST interface.
ALTER TABLE workspace RENAME TO activity;
ALTER TABLE workspace_file RENAME TO activity_file;
ALTER TABLE workspace_model RENAME TO activity_model;
ALTER TABLE workspace_method RENAME TO activity_method;
ALTER TABLE workspace_owner RENAME TO activity_owner;
ALTER TABLE activity_file RENAME COLUMN workspace_id TO activity_id;
ALTER TABLE activity_model RENAME COLUMN workspace_id TO activity_id;
ALTER TABLE activity_method RENAME COLUMN workspace_id TO activity_id;
ALTER TABLE activity_owner RENAME COLUMN workspace_id TO activity_id;
ALTER TABLE suite RENAME COLUMN workspace_id TO activity_id;
ALTER TABLE build RENAME COLUMN workspace_id TO activity_id;
ALTER TABLE schedule RENAME COLUMN workspace_id TO activity_id;
ALTER INDEX workspace_by_creation RENAME TO activity_by_creation;
ALTER INDEX workspace_file_by_content RENAME TO activity_file_by_content;
ALTER INDEX workspace_owner_by_person RENAME TO activity_owner_by_person;
ALTER INDEX suite_by_workspace RENAME TO suite_by_activity;
ALTER INDEX build_by_workspace RENAME TO build_by_activity;
ALTER INDEX schedule_by_workspace RENAME TO schedule_by_activity;

-- A build with several agents consists of shards.
ALTER TABLE build RENAME COLUMN part TO shard;
ALTER TABLE build RENAME COLUMN parts TO shards;
ALTER TABLE schedule RENAME COLUMN parts TO shards;
