-- Files of activities and of test applications, each stored once.
CREATE TABLE file_content (
  sha256  VARCHAR(64) PRIMARY KEY,
  size    BIGINT      NOT NULL,
  content CONTENT     NOT NULL
);

CREATE TABLE workspace (
  id              VARCHAR(36)   PRIMARY KEY,
  name            VARCHAR(200)  NOT NULL,
  description     VARCHAR(4000) NOT NULL,
  language        VARCHAR(20)   NOT NULL,
  component_class VARCHAR(1000) NOT NULL,
  created         TIMESTAMP WITH TIME ZONE NOT NULL,
  updated         TIMESTAMP WITH TIME ZONE NOT NULL,
  version         BIGINT        NOT NULL
);
CREATE INDEX workspace_by_creation ON workspace (created, id);

CREATE TABLE workspace_file (
  workspace_id VARCHAR(36)  NOT NULL REFERENCES workspace (id) ON DELETE CASCADE,
  path         VARCHAR(400) NOT NULL,
  sha256       VARCHAR(64)  NOT NULL REFERENCES file_content (sha256),
  size         BIGINT       NOT NULL,
  PRIMARY KEY (workspace_id, path)
);

CREATE TABLE workspace_model (
  workspace_id   VARCHAR(36)  NOT NULL REFERENCES workspace (id) ON DELETE CASCADE,
  position       INTEGER      NOT NULL,
  name           VARCHAR(400) NOT NULL,
  path           VARCHAR(400) NOT NULL,
  interface_name VARCHAR(400),
  method         VARCHAR(400) NOT NULL,
  PRIMARY KEY (workspace_id, position)
);

CREATE TABLE workspace_method (
  workspace_id   VARCHAR(36)  NOT NULL REFERENCES workspace (id) ON DELETE CASCADE,
  position       INTEGER      NOT NULL,
  interface_name VARCHAR(400) NOT NULL,
  required       BOOLEAN      NOT NULL,
  method         VARCHAR(400) NOT NULL,
  PRIMARY KEY (workspace_id, position)
);

CREATE TABLE suite (
  id           VARCHAR(36)  PRIMARY KEY,
  workspace_id VARCHAR(36)  NOT NULL REFERENCES workspace (id) ON DELETE CASCADE,
  model        VARCHAR(400) NOT NULL,
  name         VARCHAR(400) NOT NULL,
  seed         BIGINT       NOT NULL,
  total        INTEGER      NOT NULL,
  valid        INTEGER      NOT NULL,
  created      TIMESTAMP WITH TIME ZONE NOT NULL,
  version      BIGINT       NOT NULL,
  document     CONTENT      NOT NULL
);
CREATE INDEX suite_by_workspace ON suite (workspace_id, created, id);

CREATE TABLE suite_note (
  suite_id VARCHAR(36)   NOT NULL REFERENCES suite (id) ON DELETE CASCADE,
  position INTEGER       NOT NULL,
  severity VARCHAR(10)   NOT NULL,
  file     VARCHAR(400)  NOT NULL,
  line     INTEGER       NOT NULL,
  element  VARCHAR(1000) NOT NULL,
  message  VARCHAR(4000) NOT NULL,
  PRIMARY KEY (suite_id, position)
);

CREATE TABLE schedule (
  id       VARCHAR(36) PRIMARY KEY,
  suite_id VARCHAR(36) NOT NULL REFERENCES suite (id) ON DELETE CASCADE,
  fire_at  TIMESTAMP WITH TIME ZONE NOT NULL,
  zone     VARCHAR(60) NOT NULL,
  created  TIMESTAMP WITH TIME ZONE NOT NULL,
  fired    TIMESTAMP WITH TIME ZONE
);

CREATE TABLE build (
  id               VARCHAR(36)   PRIMARY KEY,
  workspace_id     VARCHAR(36)   NOT NULL REFERENCES workspace (id) ON DELETE CASCADE,
  activity_name    VARCHAR(200)  NOT NULL,
  suite_id         VARCHAR(36)   NOT NULL REFERENCES suite (id) ON DELETE CASCADE,
  model            VARCHAR(400)  NOT NULL,
  language         VARCHAR(20)   NOT NULL,
  state            VARCHAR(20)   NOT NULL,
  attempt          INTEGER       NOT NULL,
  agent            VARCHAR(100),
  created          TIMESTAMP WITH TIME ZONE NOT NULL,
  started          TIMESTAMP WITH TIME ZONE,
  finished         TIMESTAMP WITH TIME ZONE,
  version          BIGINT        NOT NULL,
  cases_total      INTEGER       NOT NULL,
  cases_seen       CONTENT       NOT NULL,
  cases_done       INTEGER       NOT NULL,
  failure_category VARCHAR(20),
  failure_message  VARCHAR(4000),
  total            INTEGER,
  pass             INTEGER,
  fail             INTEGER,
  error            INTEGER,
  dont             INTEGER,
  unjudged         INTEGER,
  schedule_id      VARCHAR(36),
  fire_time        TIMESTAMP WITH TIME ZONE,
  log_length       BIGINT        NOT NULL DEFAULT 0,
  CONSTRAINT build_once_per_fire_time UNIQUE (schedule_id, fire_time)
);
CREATE INDEX build_by_creation ON build (created, id);
CREATE INDEX build_by_state ON build (state, created);
CREATE INDEX build_by_workspace ON build (workspace_id, created);

CREATE TABLE build_file (
  build_id VARCHAR(36)  NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  path     VARCHAR(400) NOT NULL,
  sha256   VARCHAR(64)  NOT NULL REFERENCES file_content (sha256),
  size     BIGINT       NOT NULL,
  PRIMARY KEY (build_id, path)
);

CREATE TABLE build_diagnostic (
  build_id     VARCHAR(36)   NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  position     INTEGER       NOT NULL,
  file         VARCHAR(1000) NOT NULL,
  line         INTEGER       NOT NULL,
  column_no    INTEGER       NOT NULL,
  message      VARCHAR(4000) NOT NULL,
  is_generated BOOLEAN       NOT NULL,
  PRIMARY KEY (build_id, position)
);

CREATE TABLE build_transition (
  build_id    VARCHAR(36)   NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  position    INTEGER       NOT NULL,
  attempt     INTEGER       NOT NULL,
  state       VARCHAR(20)   NOT NULL,
  at_time     TIMESTAMP WITH TIME ZONE NOT NULL,
  cause       VARCHAR(1000) NOT NULL,
  PRIMARY KEY (build_id, position)
);

-- Fencing tokens grow for ever, across all builds.
CREATE SEQUENCE fencing_token START WITH 1 INCREMENT BY 1;

CREATE TABLE attempt (
  token         BIGINT       PRIMARY KEY,
  build_id      VARCHAR(36)  NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  no            INTEGER      NOT NULL,
  agent         VARCHAR(100) NOT NULL,
  state         VARCHAR(20)  NOT NULL,
  leased        TIMESTAMP WITH TIME ZONE NOT NULL,
  lease_until   TIMESTAMP WITH TIME ZONE NOT NULL,
  finished      TIMESTAMP WITH TIME ZONE,
  log_start     BIGINT       NOT NULL,
  result_sha256 VARCHAR(64),
  UNIQUE (build_id, no)
);
CREATE INDEX attempt_by_lease ON attempt (finished, lease_until);

-- A result that came after its attempt was given up: kept for people, counted nowhere.
CREATE TABLE superseded_result (
  token    BIGINT      PRIMARY KEY REFERENCES attempt (token) ON DELETE CASCADE,
  received TIMESTAMP WITH TIME ZONE NOT NULL,
  document CONTENT     NOT NULL
);

-- Build agents that ever registered.
CREATE TABLE agent (
  name      VARCHAR(100) PRIMARY KEY,
  version   VARCHAR(100) NOT NULL,
  slots     INTEGER      NOT NULL,
  last_seen TIMESTAMP WITH TIME ZONE NOT NULL
);

CREATE TABLE agent_toolchain (
  agent_name VARCHAR(100) NOT NULL REFERENCES agent (name) ON DELETE CASCADE,
  position   INTEGER      NOT NULL,
  language   VARCHAR(20)  NOT NULL,
  version    VARCHAR(200) NOT NULL,
  PRIMARY KEY (agent_name, position)
);

-- The accepted result of a build: the document as it came, and rows of it for paging and statistics.
CREATE TABLE result (
  build_id VARCHAR(36)  PRIMARY KEY REFERENCES build (id) ON DELETE CASCADE,
  sha256   VARCHAR(64)  NOT NULL,
  received TIMESTAMP WITH TIME ZONE NOT NULL,
  document CONTENT      NOT NULL,
  overview VARCHAR      NOT NULL
);

CREATE TABLE result_case (
  build_id           VARCHAR(36) NOT NULL REFERENCES result (build_id) ON DELETE CASCADE,
  no                 INTEGER     NOT NULL,
  verdict            VARCHAR(10) NOT NULL,
  processing_time_us DOUBLE PRECISION,
  outcome            VARCHAR     NOT NULL,
  PRIMARY KEY (build_id, no)
);
CREATE INDEX result_case_by_verdict ON result_case (build_id, verdict, no);
