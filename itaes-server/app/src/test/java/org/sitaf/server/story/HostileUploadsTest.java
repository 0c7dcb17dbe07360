package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Malicious uploads are rejected with a reason, and the server accepts valid ones afterwards. */
@Tag("slow")
class HostileUploadsTest extends ServerTest {
  private static final String DATA = "../../tests/faults/hostile/uploads.py";

  @Test
  void hostileUploadsAreRejectedWithAReason() throws Exception {
    Path folder = generated();
    List<String> wrong = new ArrayList<>();
    int tried = 0;
    for (JsonNode upload : JsonMapper.shared().readTree(folder.resolve("index.json"))) {
      if (upload.get("file").isNull()) {
        continue;
      }
      byte[] body = Files.readAllBytes(folder.resolve(upload.get("file").asString()));
      Api.Answer answer = api.post("/api/v1/activities", upload.get("type").asString(), body);
      tried++;
      List<Integer> expected = new ArrayList<>();
      upload.get("expected").forEach(status -> expected.add(status.asInt()));
      String description =
          "%s: %d %s"
              .formatted(
                  upload.get("name").asString(),
                  answer.status(),
                  answer.text().substring(0, Math.min(300, answer.text().length())));
      if (!expected.contains(answer.status())
          || answer.status() >= 400 && !answer.text().contains("\"detail\"")) {
        wrong.add(description);
      }
      if (answer.status() == 201) {
        api.delete("/api/v1/activities/" + answer.id()).expect(204);
      }
    }
    assertThat(wrong).isEmpty();
    assertThat(tried).isGreaterThan(80);
    assertThat(Files.exists(Path.of("/tmp/sitaf-slip"))).isFalse();
    assertThat(Files.exists(Path.of("/tmp/sitaf-absolute"))).isFalse();
    api.upload(Activities.zip());
  }

  @Test
  void longTextsInEveryFieldAreRejectedWithoutServerError() {
    String id = api.upload(Activities.zip());
    String files = new String(Activities.files().get("activity.yaml"), StandardCharsets.UTF_8);
    for (String field : List.of("name: ir-sensor", "description: Infrared", "class: org")) {
      for (int length : List.of(201, 401, 1001, 4001, 70_000)) {
        String changed = files.replace(field, field + "x".repeat(length));
        Map<String, byte[]> all = Activities.files();
        all.put("activity.yaml", changed.getBytes(StandardCharsets.UTF_8));
        Api.Answer answer =
            api.put(
                "/api/v1/activities/" + id + "/content",
                "application/zip",
                Activities.zip(all),
                "*");
        assertThat(answer.status()).as(field + " " + length + answer.text()).isIn(200, 400, 422);
      }
    }
  }

  private static Path generated() throws IOException, InterruptedException {
    Path folder = temporary();
    Process python = new ProcessBuilder("python3", DATA, folder.toString()).inheritIO().start();
    assertThat(python.waitFor(2, TimeUnit.MINUTES)).isTrue();
    assertThat(python.exitValue()).isZero();
    return folder;
  }
}
