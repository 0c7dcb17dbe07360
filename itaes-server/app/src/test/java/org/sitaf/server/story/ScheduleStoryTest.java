package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.OffsetDateTime;
import java.time.ZoneOffset;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.quartz.JobKey;
import org.quartz.Scheduler;
import org.quartz.impl.matchers.GroupMatcher;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import tools.jackson.databind.JsonNode;

/** Reserved builds. */
@Tag("slow")
class ScheduleStoryTest extends ServerTest {
  @Autowired private Scheduler quartz;

  @Test
  void aReservedBuildIsRequestedAtItsTimeAndOnce() throws Exception {
    String activityId = api.upload(Activities.zip());
    String suiteId = api.suite(activityId);
    OffsetDateTime at = OffsetDateTime.now(ZoneOffset.ofHours(9)).plusSeconds(3);
    JsonNode schedule =
        api.post("/api/v1/schedules", "{\"suiteId\":\"%s\",\"at\":\"%s\"}".formatted(suiteId, at))
            .expect(201)
            .json();
    assertThat(schedule.get("at").asString()).endsWith("+09:00");
    assertThat(schedule.has("fired")).isFalse();
    assertThat(builds(activityId)).isEmpty();
    String id = schedule.get("id").asString();
    await().until(() -> api.get("/api/v1/schedules/" + id).json().has("fired"));
    assertThat(builds(activityId))
        .hasSize(1)
        .allSatisfy(b -> assertThat(b.get("scheduleId").asString()).isEqualTo(id));
  }

  @Test
  void aReservationThatIsGivenUpRequestsNothing() throws Exception {
    String activityId = api.upload(Activities.zip());
    String suiteId = api.suite(activityId);
    String id =
        api.post(
                "/api/v1/schedules",
                "{\"suiteId\":\"%s\",\"at\":\"2099-01-01T00:00:00Z\"}".formatted(suiteId))
            .expect(201)
            .id();
    assertThat(quartz.getJobKeys(GroupMatcher.anyJobGroup()))
        .extracting(JobKey::getName)
        .contains(id);
    api.delete("/api/v1/schedules/" + id).expect(204);
    assertThat(quartz.getJobKeys(GroupMatcher.anyJobGroup()))
        .extracting(JobKey::getName)
        .doesNotContain(id);
    assertThat(builds(activityId)).isEmpty();
  }

  @Test
  void aTimeThatIsPastOrNoTimeIsRefused() {
    String suiteId = api.suite(api.upload(Activities.zip()));
    api.post(
            "/api/v1/schedules",
            "{\"suiteId\":\"%s\",\"at\":\"2001-01-01T00:00:00Z\"}".formatted(suiteId))
        .expect(400);
    api.post("/api/v1/schedules", "{\"suiteId\":\"%s\",\"at\":\"tomorrow\"}".formatted(suiteId))
        .expect(400);
    api.post("/api/v1/schedules", "{\"suiteId\":\"none\",\"at\":\"2099-01-01T00:00:00Z\"}")
        .expect(404);
  }

  private JsonNode builds(String activityId) {
    return api.get("/api/v1/builds?activityId=" + activityId).expect(200).json().get("items");
  }
}
