package org.sitaf.server.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.transaction.support.TransactionTemplate;

/** Shards are cancelled when their build has ended. */
class ShardedBuildsTest extends ServerTest {
  @Autowired private ShardedBuilds shardedBuilds;
  @Autowired private JdbcClient jdbc;
  @Autowired private TransactionTemplate transaction;

  private String build = "";

  @BeforeEach
  void requestShards() {
    String suite = api.suite(api.upload(Activities.zip()));
    build =
        api.post("/api/v1/builds", "{\"suiteId\":\"%s\",\"shards\":3}".formatted(suite))
            .expect(201)
            .id();
  }

  @AfterEach
  void cancelShards() {
    shardedBuilds.check();
  }

  @Test
  void shardsAreCancelledAfterTheServerDied() {
    jdbc.sql("UPDATE build SET state = 'CANCELLED', finished = created WHERE id = ?")
        .param(build)
        .update();
    shardedBuilds.check();
    assertThat(states()).containsExactly("CANCELLED", "CANCELLED", "CANCELLED");
  }

  @Test
  void shardsOfAFailedBuildAreCancelled() {
    jdbc.sql("UPDATE build SET state = 'FAILED', finished = created WHERE id = ?")
        .param(build)
        .update();
    shardedBuilds.check();
    assertThat(states()).containsExactly("CANCELLED", "CANCELLED", "CANCELLED");
  }

  @Test
  void lockedShardDoesNotPreventCancellingTheOthers() {
    transaction.executeWithoutResult(
        status -> {
          jdbc.sql("SELECT id FROM build WHERE parent_id = ? AND shard = 1 FOR UPDATE")
              .param(build)
              .query()
              .singleValue();
          api.post("/api/v1/builds/" + build + "/cancel", "").expect(200);
          await()
              .untilAsserted(
                  () -> assertThat(states()).containsExactly("QUEUED", "CANCELLED", "CANCELLED"));
        });
    shardedBuilds.check();
    assertThat(states()).containsExactly("CANCELLED", "CANCELLED", "CANCELLED");
  }

  private List<String> states() {
    return jdbc.sql("SELECT state FROM build WHERE parent_id = ? ORDER BY shard")
        .param(build)
        .query(String.class)
        .list();
  }
}
