package org.sitaf.server.web;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.net.http.HttpRequest.BodyPublishers;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** Sorting of lists, and the size limit of JSON bodies. */
class ListingTest extends ServerTest {
  @Test
  void listIsSortedByTheRequestedProperty() {
    String activity = api.upload(Activities.zip());
    for (int i = 0; i < 3; i++) {
      api.suite(activity);
    }
    String suites = "/api/v1/activities/" + activity + "/suites";
    List<String> byDefault = values(suites, "created");
    assertThat(byDefault).hasSize(3).isSortedAccordingTo(Comparator.reverseOrder());
    assertThat(values(suites + "?sort=-created", "created")).isEqualTo(byDefault);
    assertThat(values(suites + "?sort=created", "created")).isEqualTo(reversed(byDefault));
    assertThat(values("/api/v1/activities?sort=name&size=500", "name")).isSorted();
    assertThat(values("/api/v1/builds?sort=-priority&size=500", "id")).doesNotHaveDuplicates();
    assertThat(values("/api/v1/schedules?sort=name", "name")).isSorted();
  }

  @Test
  void unknownSortPropertyIsReported() {
    for (String list : List.of("activities", "builds", "schedules")) {
      Api.Answer rejected = api.get("/api/v1/" + list + "?sort=secret").expect(400);
      assertThat(rejected.json().get("detail").asString())
          .startsWith("sort must be one of created")
          .endsWith("not secret.");
    }
  }

  @Test
  void jsonBeyondTheLimitIsRejected() {
    String large = "{\"name\":\"" + "x".repeat(100_000) + "\"}";
    Api.Answer withLength = api.post("/api/v1/session", large);
    assertThat(withLength.status()).isEqualTo(413);
    assertThat(withLength.json().get("detail").asString()).contains("larger than 64 KiB");
    byte[] bytes = large.getBytes(StandardCharsets.UTF_8);
    Api.Answer chunked =
        api.send(
            api.request("/api/v1/session")
                .header("Content-Type", "application/json")
                .POST(BodyPublishers.ofInputStream(() -> new ByteArrayInputStream(bytes))));
    assertThat(chunked.status()).isEqualTo(413);
  }

  private static List<String> reversed(List<String> list) {
    List<String> copy = new ArrayList<>(list);
    Collections.reverse(copy);
    return copy;
  }

  private List<String> values(String path, String field) {
    JsonNode items = api.get(path).expect(200).json().get("items");
    return StreamSupport.stream(items.spliterator(), false)
        .map(item -> item.get(field).asString())
        .toList();
  }
}
