CREATE TABLE webhook (
  id         VARCHAR(36)   PRIMARY KEY,
  url        VARCHAR(2000) NOT NULL,
  -- Signs what is sent, and so is needed as it is.
  secret     VARCHAR(100)  NOT NULL,
  -- Only builds of activities of this name; null for all.
  activity   VARCHAR(200),
  created    TIMESTAMP WITH TIME ZONE NOT NULL,
  created_by VARCHAR(60)   NOT NULL
);

-- What is to be sent, written in the transaction in which the build ends: it is sent at least once.
CREATE TABLE webhook_delivery (
  id          VARCHAR(36) PRIMARY KEY,
  webhook_id  VARCHAR(36) NOT NULL REFERENCES webhook (id) ON DELETE CASCADE,
  build_id    VARCHAR(36) NOT NULL REFERENCES build (id) ON DELETE CASCADE,
  payload     VARCHAR     NOT NULL,
  state       VARCHAR(20) NOT NULL,
  tries       INTEGER     NOT NULL,
  due         TIMESTAMP WITH TIME ZONE NOT NULL,
  created     TIMESTAMP WITH TIME ZONE NOT NULL,
  last_answer VARCHAR(400),
  UNIQUE (webhook_id, build_id)
);
CREATE INDEX webhook_delivery_by_due ON webhook_delivery (state, due);
