package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.ServerTest;
import tools.jackson.databind.JsonNode;

/** Tags of activities, which filter lists. */
abstract class TagStory extends ServerTest {
  private Api.Answer tag(String id, String names) {
    byte[] body = ("{\"tags\": " + names + "}").getBytes(java.nio.charset.StandardCharsets.UTF_8);
    return api.put("/api/v1/activities/" + id + "/tags", "application/json", body, null);
  }

  private List<String> found(String query) {
    JsonNode items =
        api.get("/api/v1/activities?size=500&" + query).expect(200).json().get("items");
    return items.valueStream().map(item -> item.get("id").asString()).toList();
  }

  @Test
  void activitiesAreFoundByTheirTags() {
    String left = api.upload(Activities.zip());
    String both = api.upload(Activities.zip());
    long version = api.get("/api/v1/activities/" + both).json().get("version").asLong();
    tag(left, "[\"arm/left\"]").expect(200);
    JsonNode tagged = tag(both, "[\"nightly\", \"arm/left\", \"nightly\"]").expect(200).json();
    assertThat(tagged.get("tags"))
        .extracting(JsonNode::asString)
        .containsExactly("arm/left", "nightly");
    assertThat(tagged.get("version").asLong()).as("the files did not change").isEqualTo(version);

    assertThat(found("tag=arm/left")).containsExactlyInAnyOrder(left, both);
    assertThat(found("tag=arm/left&tag=nightly")).containsExactly(both);
    assertThat(found("tag=nightly&search=IR-SENS")).containsExactly(both);
    assertThat(found("tag=nightly&search=other")).isEmpty();
    assertThat(found("tag=nightly&name=ir-sensor")).containsExactly(both);
    assertThat(found("tag=nightly&name=ir")).isEmpty();
    assertThat(found("tag=unknown")).isEmpty();
    assertThat(api.get("/api/v1/tags").expect(200).json().toString())
        .isEqualTo(
            "[{\"name\":\"arm/left\",\"activities\":2},{\"name\":\"nightly\",\"activities\":1}]");

    tag(both, "[]").expect(200);
    assertThat(found("tag=arm/left")).containsExactly(left);
    api.delete("/api/v1/activities/" + left).expect(204);
    api.delete("/api/v1/activities/" + both).expect(204);
    assertThat(api.get("/api/v1/tags").json().isEmpty()).isTrue();
  }

  @Test
  void tagsOfAnotherFormAreRefused() {
    String id = api.upload(Activities.zip());
    for (String names :
        List.of(
            "null",
            "[null]",
            "[\"\"]",
            "[\"two words\"]",
            "[\"<b>\"]",
            "[\"" + "x".repeat(51) + "\"]",
            IntStream.range(0, 21).mapToObj(i -> "\"t" + i + "\"").toList().toString())) {
      assertThat(tag(id, names).expect(400).text()).as(names).contains("tags");
    }
    assertThat(api.get("/api/v1/activities/" + id).json().get("tags").isEmpty()).isTrue();
    tag("00000000-0000-0000-0000-000000000000", "[]").expect(404);
    api.delete("/api/v1/activities/" + id).expect(204);
  }
}
