-- Where the files of an activity come from.
CREATE TABLE git_source (
  id              VARCHAR(36)   PRIMARY KEY,
  activity_id     VARCHAR(36)   NOT NULL UNIQUE REFERENCES activity (id) ON DELETE CASCADE,
  url             VARCHAR(2000) NOT NULL,
  branch          VARCHAR(250)  NOT NULL,
  folder          VARCHAR(400)  NOT NULL,
  credential_kind VARCHAR(12)   NOT NULL,
  credential_user VARCHAR(200)  NOT NULL,
  -- Encrypted; the key is not in the database.
  secret          VARCHAR(30000),
  -- Fingerprint of the key of an ssh host, from the first connection.
  host_key        VARCHAR(200),
  policy          VARCHAR(10)   NOT NULL,
  interval_s      INTEGER       NOT NULL,
  version         BIGINT        NOT NULL,
  created         TIMESTAMP WITH TIME ZONE NOT NULL,
  -- The newest commit of the branch that was read, and when it was fetched.
  head            VARCHAR(64),
  fetched         TIMESTAMP WITH TIME ZONE,
  problem         VARCHAR(4000),
  problem_since   TIMESTAMP WITH TIME ZONE,
  -- The server that works on it; another one takes over when the time has passed.
  claimed_by      VARCHAR(36),
  claimed_until   TIMESTAMP WITH TIME ZONE
);

CREATE TABLE git_commit (
  id         VARCHAR(36)   PRIMARY KEY,
  source_id  VARCHAR(36)   NOT NULL REFERENCES git_source (id) ON DELETE CASCADE,
  sha        VARCHAR(64)   NOT NULL,
  -- Number of a pull or merge request; 0 for the branch.
  request_no INTEGER       NOT NULL,
  position   BIGINT        NOT NULL,
  subject    VARCHAR(400)  NOT NULL,
  author     VARCHAR(400)  NOT NULL,
  authored   TIMESTAMP WITH TIME ZONE NOT NULL,
  received   TIMESTAMP WITH TIME ZONE NOT NULL,
  ended      TIMESTAMP WITH TIME ZONE,
  state      VARCHAR(12)   NOT NULL,
  problem    VARCHAR(4000),
  -- What it is compared with; null for the first commit.
  base_id    VARCHAR(36),
  -- A force-push has removed it from the branch.
  replaced   BOOLEAN       NOT NULL DEFAULT FALSE,
  UNIQUE (source_id, sha, request_no)
);
CREATE INDEX git_commit_by_position ON git_commit (source_id, request_no, position);
CREATE INDEX git_commit_by_state ON git_commit (state);

-- A model of a commit, and the build that has its result.
CREATE TABLE git_cell (
  commit_id  VARCHAR(36)  NOT NULL REFERENCES git_commit (id) ON DELETE CASCADE,
  model      VARCHAR(400) NOT NULL,
  position   INTEGER      NOT NULL,
  -- Of everything that the build can read.
  digest     VARCHAR(64)  NOT NULL,
  build_id   VARCHAR(36)  NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  -- The commit whose result was taken over; null for a build of this commit.
  taken_from VARCHAR(64),
  -- Cases compared with the base and those that differ; null if not compared.
  compared   INTEGER,
  differing  INTEGER,
  PRIMARY KEY (commit_id, model)
);
CREATE INDEX git_cell_by_build ON git_cell (build_id);
CREATE INDEX git_cell_by_digest ON git_cell (digest);

-- Equal suites of an activity's commits are stored once.
CREATE TABLE git_suite (
  activity_id VARCHAR(36)  NOT NULL REFERENCES activity (id) ON DELETE CASCADE,
  model       VARCHAR(400) NOT NULL,
  sha256      VARCHAR(64)  NOT NULL,
  suite_id    VARCHAR(36)  NOT NULL REFERENCES suite (id) ON DELETE CASCADE,
  PRIMARY KEY (activity_id, model, sha256)
);
