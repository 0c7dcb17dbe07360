-- Searches for the first bad commit between two commits of a branch that were built.
CREATE TABLE git_bisection (
  source_id      VARCHAR(36)   NOT NULL REFERENCES git_source (id) ON DELETE CASCADE,
  bisection_no   INTEGER       NOT NULL,
  -- The source while it runs, so that each source has at most one that does.
  running_source VARCHAR(36)   UNIQUE,
  -- Of the source when somebody asked. If they change, the search ends.
  url            VARCHAR(2000) NOT NULL,
  branch         VARCHAR(250)  NOT NULL,
  folder         VARCHAR(400)  NOT NULL,
  good           VARCHAR(64)   NOT NULL,
  bad            VARCHAR(64)   NOT NULL,
  kind           VARCHAR(10)   NOT NULL,
  -- What somebody asked for; null for everything that came with the bad commit.
  case_no        INTEGER,
  output         VARCHAR(400),
  criterion      VARCHAR(2000) NOT NULL,
  state          VARCHAR(10)   NOT NULL,
  problem        VARCHAR(4000),
  asked_by       VARCHAR(200)  NOT NULL,
  created        TIMESTAMP WITH TIME ZONE NOT NULL,
  ended          TIMESTAMP WITH TIME ZONE,
  PRIMARY KEY (source_id, bisection_no)
);

-- The models that decide, and the builds of the good and the bad commit.
CREATE TABLE git_bisection_model (
  source_id    VARCHAR(36)  NOT NULL,
  bisection_no INTEGER      NOT NULL,
  position     INTEGER      NOT NULL,
  model        VARCHAR(400) NOT NULL,
  good_build   VARCHAR(36)  NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  bad_build    VARCHAR(36)  NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  PRIMARY KEY (source_id, bisection_no, position),
  FOREIGN KEY (source_id, bisection_no) REFERENCES git_bisection (source_id, bisection_no)
    ON DELETE CASCADE
);

-- The commits after the good one up to the bad one, the oldest first. The builds of those that are
-- tested belong to rows of git_commit with the request_no -bisection_no.
CREATE TABLE git_bisection_commit (
  source_id    VARCHAR(36)  NOT NULL,
  bisection_no INTEGER      NOT NULL,
  position     INTEGER      NOT NULL,
  sha          VARCHAR(64)  NOT NULL,
  subject      VARCHAR(400) NOT NULL,
  author       VARCHAR(400) NOT NULL,
  authored     TIMESTAMP WITH TIME ZONE NOT NULL,
  -- Null until it was tested.
  outcome      VARCHAR(10),
  reason       VARCHAR(1000),
  -- The order of the tests, from 1.
  test_no      INTEGER,
  PRIMARY KEY (source_id, bisection_no, position),
  FOREIGN KEY (source_id, bisection_no) REFERENCES git_bisection (source_id, bisection_no)
    ON DELETE CASCADE
);
