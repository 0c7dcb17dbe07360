-- How often agents reported that the infrastructure failed; attempts whose agent was lost do not count.
ALTER TABLE build ADD COLUMN failures INTEGER DEFAULT 0 NOT NULL;
