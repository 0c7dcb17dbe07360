package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.charset.StandardCharsets;
import java.time.DayOfWeek;
import java.time.Instant;
import java.time.LocalTime;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.time.ZonedDateTime;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.quartz.JobKey;
import org.quartz.JobPersistenceException;
import org.quartz.Scheduler;
import org.quartz.impl.matchers.GroupMatcher;
import org.sitaf.server.support.Activities;
import org.sitaf.server.support.ServerTest;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Schedules of single and periodic builds. */
@Tag("slow")
class ScheduleStoryTest extends ServerTest {
  private static final String JSON = "application/json";

  @Autowired private Scheduler quartz;
  @Autowired private JdbcClient jdbc;

  @Test
  void reservedBuildIsRequestedOnceAtItsTime() throws Exception {
    String activityId = api.upload(Activities.zip());
    String suiteId = api.suite(activityId);
    OffsetDateTime at = OffsetDateTime.now(ZoneOffset.ofHours(9)).plusSeconds(3);
    JsonNode schedule =
        api.post(
                "/api/v1/schedules",
                "{\"suiteId\":\"%s\",\"at\":\"%s\",\"recordings\":\"FAILED\"}"
                    .formatted(suiteId, at))
            .expect(201)
            .json();
    assertThat(schedule.get("at").asString()).endsWith("+09:00");
    assertThat(schedule.get("recordings").asString()).isEqualTo("FAILED");
    assertThat(schedule.has("fired")).isFalse();
    assertThat(builds(activityId)).isEmpty();
    String id = schedule.get("id").asString();
    await().until(() -> api.get("/api/v1/schedules/" + id).json().has("fired"));
    assertThat(builds(activityId))
        .hasSize(1)
        .allSatisfy(b -> assertThat(b.get("scheduleId").asString()).isEqualTo(id))
        .allSatisfy(b -> assertThat(b.get("recordedCases").asString()).isEqualTo("FAILED"));
  }

  @Test
  void failedFireTimeIsRetried() throws Exception {
    String activityId = api.upload(Activities.zip());
    String id =
        api.post(
                "/api/v1/schedules",
                "{\"suiteId\":\"%s\",\"at\":\"2099-01-01T00:00:00Z\"}"
                    .formatted(api.suite(activityId)))
            .expect(201)
            .id();
    JobKey job =
        quartz.getJobKeys(GroupMatcher.anyJobGroup()).stream()
            .filter(key -> key.getName().equals(id))
            .findFirst()
            .orElseThrow();
    jdbc.sql("ALTER TABLE schedule_fire RENAME TO schedule_fire_away").update();
    try {
      quartz.triggerJob(job);
      // Quartz reads a trigger in two steps and throws if it fired and was removed in between.
      await()
          .ignoreException(JobPersistenceException.class)
          .until(() -> quartz.getTriggersOfJob(job).size() == 2);
    } finally {
      jdbc.sql("ALTER TABLE schedule_fire_away RENAME TO schedule_fire").update();
    }
    await().untilAsserted(() -> assertThat(builds(activityId)).hasSize(1));
  }

  @Test
  void deletedReservationRequestsNoBuild() throws Exception {
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
  void pastOrInvalidTimeIsRejected() {
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

  @Test
  void previewListsFireTimes() {
    api.put("/api/v1/calendars/mondays", JSON, bytes("{\"weekdays\":[\"MONDAY\"]}"), null)
        .expect(200);
    JsonNode times =
        api.post(
                "/api/v1/schedules/preview?count=4",
                "{\"cron\": \"30 3 * * 1,2\", \"zone\": \"Asia/Seoul\", \"leaveOut\":"
                    + " [\"mondays\"]}")
            .expect(200)
            .json();
    assertThat(times).hasSize(4);
    assertThat(times)
        .allSatisfy(
            time -> {
              ZonedDateTime there = Instant.parse(time.asString()).atZone(ZoneId.of("Asia/Seoul"));
              assertThat(there.getDayOfWeek()).isEqualTo(DayOfWeek.TUESDAY);
              assertThat(there.toLocalTime()).isEqualTo(LocalTime.of(3, 30));
            });
    assertThat(api.post("/api/v1/schedules/preview", "{\"cron\": \"soon\"}").expect(400).text())
        .contains("is not a cron expression");
    api.post("/api/v1/schedules/preview?count=0", "{\"everyMinutes\": 5}").expect(400);
  }

  @Test
  void periodicScheduleListsFireTimesAndCanBePaused() {
    String activityId = api.upload(Activities.zip());
    api.put("/api/v1/calendars/holidays", JSON, bytes("{\"weekdays\":[\"SUNDAY\"]}"), null)
        .expect(200);
    JsonNode schedule =
        api.post(
                "/api/v1/schedules",
                """
                {"name": "nightly", "activityId": "%s", "model": "GetInfraredData", "seed": 7,
                 "cron": "30 3 * * 0,1", "zone": "Asia/Seoul", "leaveOut": ["holidays"],
                 "misfire": "SKIP", "priority": 3, "shards": 2, "retries": 1}
                """
                    .formatted(activityId))
            .expect(201)
            .json();
    String path = "/api/v1/schedules/" + schedule.get("id").asString();
    JsonNode times = api.get(path + "/fire-times").expect(200).json();
    assertThat(times).hasSize(10);
    assertThat(times)
        .allSatisfy(
            time -> {
              ZonedDateTime there = Instant.parse(time.asString()).atZone(ZoneId.of("Asia/Seoul"));
              assertThat(there.getDayOfWeek()).isEqualTo(DayOfWeek.MONDAY);
              assertThat(there.toLocalTime()).isEqualTo(LocalTime.of(3, 30));
            });
    assertThat(schedule.get("next").asString()).isEqualTo(times.get(0).asString());
    api.delete("/api/v1/calendars/holidays").expect(409);
    api.put("/api/v1/calendars/holidays", JSON, bytes("{}"), null).expect(200);
    assertThat(api.get(path + "/fire-times").json())
        .anySatisfy(
            time ->
                assertThat(
                        Instant.parse(time.asString())
                            .atZone(ZoneId.of("Asia/Seoul"))
                            .getDayOfWeek())
                    .isEqualTo(DayOfWeek.SUNDAY));
    assertThat(api.post(path + "/pause", "").expect(200).json().has("next")).isFalse();
    assertThat(api.post(path + "/resume", "").expect(200).json().has("next")).isTrue();

    JsonNode fire = api.post(path + "/run", "").expect(200).json();
    JsonNode build = api.get("/api/v1/builds/" + fire.get("buildId").asString()).json();
    assertThat(build.get("priority").asInt()).isEqualTo(3);
    assertThat(build.get("shards").asInt()).isEqualTo(2);
    JsonNode suite = api.get("/api/v1/suites/" + build.get("suiteId").asString()).json();
    assertThat(suite.get("seed").asLong()).isEqualTo(7);
    assertThat(api.get(path + "/history").json().get("items").get(0).get("buildState").asString())
        .isEqualTo("QUEUED");
    assertThat(api.get("/api/v1/schedules?activityId=" + activityId).json().get("total").asInt())
        .isEqualTo(1);
    api.post("/api/v1/builds/" + build.get("id").asString() + "/cancel", "").expect(200);
    api.delete(path).expect(204);
    api.delete("/api/v1/calendars/holidays").expect(204);
  }

  @Test
  void intervalFiresOncePerTimeAndHistoryContainsErrors() {
    String activityId = api.upload(Activities.zip());
    String at = OffsetDateTime.now(ZoneOffset.UTC).plusSeconds(1).toString();
    String path =
        "/api/v1/schedules/"
            + api.post(
                    "/api/v1/schedules",
                    """
                    {"activityId": "%s", "model": "GetInfraredData", "everyMinutes": 1, "at": "%s"}
                    """
                        .formatted(activityId, at))
                .expect(201)
                .id();
    await().until(() -> api.get(path + "/history").json().get("total").asInt() == 1);
    assertThat(api.get(path + "/history").json().get("items").get(0).has("buildId")).isTrue();
    assertThat(builds(activityId)).hasSize(1);
    api.delete(path).expect(204);
    for (JsonNode build : builds(activityId)) {
      api.post("/api/v1/builds/" + build.get("id").asString() + "/cancel", "").expect(200);
    }
  }

  @Test
  void invalidSchedulesAreRejected() {
    String suiteId = api.suite(api.upload(Activities.zip()));
    for (String rest :
        new String[] {
          "\"cron\": \"every day\"",
          "\"cron\": \"0 0 1 * 1\"",
          "\"cron\": \"* * * * *\", \"everyMinutes\": 5",
          "\"everyMinutes\": 0",
          "\"cron\": \"0 0 * * *\", \"zone\": \"Nowhere\"",
          "\"cron\": \"0 0 30 2 *\"",
          "\"everyMinutes\": 5, \"shards\": 0",
          "\"everyMinutes\": 5, \"activityId\": \"x\""
        }) {
      api.post("/api/v1/schedules", "{\"suiteId\":\"" + suiteId + "\", " + rest + "}").expect(400);
    }
    api.post(
            "/api/v1/schedules",
            "{\"suiteId\":\"" + suiteId + "\", \"everyMinutes\": 5, \"leaveOut\": [\"none\"]}")
        .expect(404);
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  private JsonNode builds(String activityId) {
    return api.get("/api/v1/builds?activityId=" + activityId).expect(200).json().get("items");
  }
}
