-- A commit of the branch that is built only to compare the heads of a request with it.
ALTER TABLE git_commit ADD COLUMN merge_base BOOLEAN DEFAULT FALSE NOT NULL;

-- Pull and merge requests that forges have reported.
CREATE TABLE git_request (
  source_id     VARCHAR(36)   NOT NULL REFERENCES git_source (id) ON DELETE CASCADE,
  request_no    INTEGER       NOT NULL,
  -- Of the source when the request was reported. If they change, the request is forgotten.
  url           VARCHAR(2000) NOT NULL,
  branch        VARCHAR(250)  NOT NULL,
  forge         VARCHAR(10)   NOT NULL,
  title         VARCHAR(400)  NOT NULL,
  author        VARCHAR(400)  NOT NULL,
  -- The newest commit.
  head          VARCHAR(64)   NOT NULL,
  is_fork       BOOLEAN       NOT NULL,
  state         VARCHAR(10)   NOT NULL,
  received      TIMESTAMP WITH TIME ZONE NOT NULL,
  updated       TIMESTAMP WITH TIME ZONE NOT NULL,
  -- The head that somebody asked to build; a fork's head is not fetched before.
  asked_head    VARCHAR(64),
  asked_by      VARCHAR(200),
  asked         TIMESTAMP WITH TIME ZONE,
  -- The head whose commits were recorded. If it is another one, the head has to be fetched.
  recorded_head VARCHAR(64),
  -- Fetches of the head that failed.
  failures      INTEGER       NOT NULL,
  problem       VARCHAR(4000),
  PRIMARY KEY (source_id, request_no)
);
