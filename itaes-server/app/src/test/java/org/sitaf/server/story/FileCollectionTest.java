package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;

/** Unreferenced file contents are deleted. */
@Tag("slow")
class FileCollectionTest extends ServerTest {
  @Autowired private StoredFiles files;
  @Autowired private JdbcClient jdbc;

  @Test
  void onlyUnreferencedContentsAreDeletedAfterAGracePeriod() {
    String activity = api.upload(Activities.zip());
    String orphan =
        files
            .store(FileTree.of(Map.of("x", "unreferenced".getBytes(StandardCharsets.UTF_8))))
            .get(0)
            .sha256();
    files.deleteUnreferenced();
    assertThat(count(orphan)).isEqualTo(1);
    jdbc.sql("UPDATE file_content SET stored = TIMESTAMP WITH TIME ZONE '2001-01-01 00:00:00Z'")
        .update();
    files.deleteUnreferenced();
    assertThat(count(orphan)).isZero();
    byte[] whole = api.get("/api/v1/activities/" + activity + "/content").expect(200).bytes();
    assertThat(whole).isEqualTo(Activities.zip());
  }

  @Test
  void storingAContentAgainRestartsTheGracePeriod() {
    FileTree tree = FileTree.of(Map.of("x", "wanted again".getBytes(StandardCharsets.UTF_8)));
    String content = files.store(tree).get(0).sha256();
    jdbc.sql("UPDATE file_content SET stored = NULL WHERE sha256 = ?").param(content).update();
    files.store(tree);
    files.deleteUnreferenced();
    assertThat(count(content)).isEqualTo(1);
  }

  private int count(String sha256) {
    return jdbc.sql("SELECT COUNT(*) FROM file_content WHERE sha256 = ?")
        .param(sha256)
        .query(Integer.class)
        .single();
  }
}
