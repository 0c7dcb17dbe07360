-- What a build asks for, and how it waits.
ALTER TABLE build ADD COLUMN priority INTEGER NOT NULL DEFAULT 0;
ALTER TABLE build ADD COLUMN max_attempts INTEGER NOT NULL DEFAULT 3;
ALTER TABLE build ADD COLUMN not_before TIMESTAMP WITH TIME ZONE;
ALTER TABLE build ADD COLUMN requirements VARCHAR(2000) NOT NULL DEFAULT '';
UPDATE build SET requirements = 'language ' || language;

-- A build whose cases are spread over several agents has parts, which are builds of their own.
ALTER TABLE build ADD COLUMN parent_id VARCHAR(36) REFERENCES build (id) ON DELETE CASCADE;
ALTER TABLE build ADD COLUMN part INTEGER NOT NULL DEFAULT 0;
ALTER TABLE build ADD COLUMN parts INTEGER NOT NULL DEFAULT 0;
ALTER TABLE build ADD COLUMN last_case INTEGER NOT NULL DEFAULT 0;
UPDATE build SET last_case = cases_total;
CREATE INDEX build_by_parent ON build (parent_id, part);

-- What an agent offers, what people decided about it, and which server it last spoke with.
ALTER TABLE agent ADD COLUMN labels VARCHAR(2000) NOT NULL DEFAULT '';
ALTER TABLE agent ADD COLUMN simulation BOOLEAN NOT NULL DEFAULT TRUE;
ALTER TABLE agent ADD COLUMN standing VARCHAR(20) NOT NULL DEFAULT 'ACTIVE';
ALTER TABLE agent ADD COLUMN refuses VARCHAR(500) NOT NULL DEFAULT '';
ALTER TABLE agent ADD COLUMN connected BOOLEAN NOT NULL DEFAULT FALSE;
CREATE INDEX attempt_by_agent ON attempt (agent, finished);

-- Contents that nothing refers to are collected once nobody can be about to refer to them.
ALTER TABLE file_content ADD COLUMN stored TIMESTAMP WITH TIME ZONE;

-- Batches of cases that an attempt has reported.
ALTER TABLE attempt ADD COLUMN next_batch BIGINT NOT NULL DEFAULT 1;
