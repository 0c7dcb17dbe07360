-- An analysis of a build is a build of another kind: it is queued, leased and cancelled like one.
ALTER TABLE build ADD COLUMN kind VARCHAR(20) DEFAULT 'TEST' NOT NULL;
ALTER TABLE build ADD COLUMN analysed_id VARCHAR(36);
-- Whether the failures of the build are explained when it ends.
ALTER TABLE build ADD COLUMN explain_failures BOOLEAN DEFAULT FALSE NOT NULL;
CREATE INDEX build_by_analysed ON build (analysed_id, kind);
-- What analyses found, as JSON.
CREATE TABLE analysis (
  build_id VARCHAR(36) PRIMARY KEY REFERENCES build (id) ON DELETE CASCADE,
  document CONTENT     NOT NULL
);
-- Whether the agent accepts analyses.
ALTER TABLE agent ADD COLUMN analyses BOOLEAN DEFAULT FALSE NOT NULL;
-- The same for the builds of a schedule.
ALTER TABLE schedule ADD COLUMN explain_failures BOOLEAN DEFAULT FALSE NOT NULL;
