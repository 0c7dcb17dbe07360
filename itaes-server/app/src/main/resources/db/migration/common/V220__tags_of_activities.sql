CREATE TABLE activity_tag (
  activity_id VARCHAR(36) NOT NULL REFERENCES activity (id) ON DELETE CASCADE,
  name VARCHAR(50) NOT NULL,
  PRIMARY KEY (activity_id, name)
);
CREATE INDEX activity_tag_name ON activity_tag (name);
