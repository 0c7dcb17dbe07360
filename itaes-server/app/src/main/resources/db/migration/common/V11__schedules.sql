-- Schedules beside reservations: periodic ones, of a suite or of one that is made anew each time.
ALTER TABLE schedule ALTER COLUMN suite_id DROP NOT NULL;
ALTER TABLE schedule ALTER COLUMN fire_at DROP NOT NULL;
ALTER TABLE schedule ADD COLUMN name VARCHAR(200) NOT NULL DEFAULT '';
ALTER TABLE schedule ADD COLUMN workspace_id VARCHAR(36) REFERENCES workspace (id) ON DELETE CASCADE;
ALTER TABLE schedule ADD COLUMN model VARCHAR(400) NOT NULL DEFAULT '';
UPDATE schedule SET workspace_id = (SELECT s.workspace_id FROM suite s WHERE s.id = schedule.suite_id),
                    model = (SELECT s.model FROM suite s WHERE s.id = schedule.suite_id);
ALTER TABLE schedule ALTER COLUMN workspace_id SET NOT NULL;
ALTER TABLE schedule ADD COLUMN seed BIGINT;
ALTER TABLE schedule ADD COLUMN cron VARCHAR(200);
ALTER TABLE schedule ADD COLUMN every_minutes INTEGER;
ALTER TABLE schedule ADD COLUMN misfire VARCHAR(10) NOT NULL DEFAULT 'ONCE';
ALTER TABLE schedule ADD COLUMN paused BOOLEAN NOT NULL DEFAULT FALSE;
ALTER TABLE schedule ADD COLUMN leave_out VARCHAR(2000) NOT NULL DEFAULT '';
ALTER TABLE schedule ADD COLUMN priority INTEGER NOT NULL DEFAULT 0;
ALTER TABLE schedule ADD COLUMN parts INTEGER NOT NULL DEFAULT 1;
ALTER TABLE schedule ADD COLUMN retries INTEGER;
ALTER TABLE schedule ADD COLUMN toolchain VARCHAR(50) NOT NULL DEFAULT '';
ALTER TABLE schedule ADD COLUMN labels VARCHAR(2000) NOT NULL DEFAULT '';
CREATE INDEX schedule_by_workspace ON schedule (workspace_id, created);

-- What came of each fire time.
CREATE TABLE schedule_fire (
  schedule_id VARCHAR(36)   NOT NULL REFERENCES schedule (id) ON DELETE CASCADE,
  fire_time   TIMESTAMP WITH TIME ZONE NOT NULL,
  noted       TIMESTAMP WITH TIME ZONE NOT NULL,
  build_id    VARCHAR(36),
  message     VARCHAR(1000) NOT NULL,
  PRIMARY KEY (schedule_id, fire_time)
);

-- Named sets of days on which nothing fires.
CREATE TABLE calendar (
  name     VARCHAR(100) PRIMARY KEY,
  days     VARCHAR      NOT NULL,
  weekdays VARCHAR(100) NOT NULL
);
