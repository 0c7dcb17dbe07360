package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.RecordingOrder;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import org.springframework.beans.factory.annotation.Autowired;
import org.springframework.jdbc.core.simple.JdbcClient;
import tools.jackson.databind.JsonNode;

/** Recordings of cases, from the upload by an agent to the download. */
abstract class RecordingStory extends DispatchStory {
  @Autowired private StoredFiles files;
  @Autowired JdbcClient jdbc;

  /** The header of a binary glTF file. */
  private static byte[] glb(int size, int content) {
    return ByteBuffer.allocate(size)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putInt(0x46546C67)
        .putInt(2)
        .putInt(size)
        .putInt(content)
        .array();
  }

  private Api.Answer recording(String build, int caseNo) {
    return api.get("/api/v1/builds/" + build + "/recordings/" + caseNo);
  }

  private List<Integer> recorded(String build, String order) {
    JsonNode list =
        api.get("/api/v1/builds/" + build + "/recordings?order=" + order).expect(200).json();
    assertThat(list.get("total").asInt()).isEqualTo(list.get("items").size());
    return list.get("items").valueStream().map(item -> item.get("caseNo").asInt()).toList();
  }

  @Test
  void recordingsAreAvailableDuringAndAfterTheBuild() {
    String id = api.build(suiteId);
    assertThat(build(id).get("recordedCases").asString()).isEqualTo("ALL");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "films", "java")) {
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getRecordings().getCases()).isEqualTo(RecordingOrder.Cases.ALL);
      assertThat(assignment.getRecordings().getMaxBytes()).isEqualTo(1L << 20);
      AttemptRef attempt = assignment.getAttempt();
      agent.uploadRecording(attempt, 3, glb(1000, 3));
      agent.uploadRecording(attempt, 7, glb(100, 7));
      agent.uploadRecording(attempt, 3, glb(1000, 3));
      assertThat(recorded(id, "CASE")).containsExactly(3, 7);
      assertThat(recorded(id, "NEWEST")).containsExactly(7, 3);
      TestApplication application = agent.download(assignment);
      agent.submit(attempt, FakeAgent.result(application, List.of()));
    }
    Api.Answer answer = recording(id, 3).expect(200);
    assertThat(answer.bytes()).isEqualTo(glb(1000, 3));
    assertThat(answer.headers().firstValue("Content-Type")).hasValue("model/gltf-binary");
    assertThat(answer.headers().allValues("Cache-Control")).containsExactly("private, no-cache");
    String etag = answer.headers().firstValue("ETag").orElseThrow();
    assertThat(etag).isEqualTo('"' + StoredFiles.sha256(glb(1000, 3)) + '"');
    String path = "/api/v1/builds/" + id + "/recordings/3";
    assertThat(api.send(api.request(path).header("If-None-Match", etag).GET()).status())
        .isEqualTo(304);
    Api.Answer part = api.send(api.request(path).header("Range", "bytes=0-3").GET()).expect(206);
    assertThat(part.text()).isEqualTo("glTF");
    recording(id, 4).expect(404);
    recording("none", 3).expect(404);
    api.get("/api/v1/builds/none/recordings").expect(404);
  }

  @Test
  void secondRunsOfRelationsAreRecordedWithTheirCases() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "second-films", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      agent.uploadRecording(attempt, 3, glb(100, 0));
      agent.uploadRecording(attempt, 3, 1, glb(100, 1));
      agent.uploadRecording(attempt, 3, 2, glb(100, 9));
      agent.uploadRecording(attempt, 3, 2, glb(200, 2));
      assertRejected(
          Status.Code.INVALID_ARGUMENT, () -> agent.uploadRecording(attempt, 3, 21, glb(20, 1)));
      // Beyond the limit of all recordings together.
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.uploadRecording(attempt, 3, 3, glb(1 << 20, 1)));
      agent.submit(attempt, FakeAgent.result(agent.download(assignment), List.of()));
    }
    assertThat(recorded(id, "CASE")).containsExactly(3);
    assertThat(recording(id, 3).expect(200).bytes()).isEqualTo(glb(100, 0));
    String path = "/api/v1/builds/" + id + "/recordings/3/relations/";
    assertThat(api.get(path + 1).expect(200).bytes()).isEqualTo(glb(100, 1));
    assertThat(api.get(path + 2).expect(200).bytes()).isEqualTo(glb(200, 2));
    api.get(path + 3).expect(404);
    // Unused contents are deleted; these are used.
    jdbc.sql("UPDATE file_content SET stored = TIMESTAMP '2000-01-01 00:00:00'").update();
    assertThat(files.deleteUnreferenced()).isNotNegative();
    assertThat(api.get(path + 1).expect(200).bytes()).isEqualTo(glb(100, 1));
  }

  @Test
  void requestedCasesAreRecorded() {
    String none = request("\"recordings\": \"NONE\"");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "no-films", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      assertThat(attempt.getBuildId()).isEqualTo(none);
      assertThat(assignment.getRecordings().getCases())
          .isEqualTo(RecordingOrder.Cases.CASES_UNSPECIFIED);
      assertRejected(
          Status.Code.INVALID_ARGUMENT, () -> agent.uploadRecording(attempt, 1, glb(20, 1)));
      agent.submit(attempt, FakeAgent.result(agent.download(assignment), List.of()));
    }
    String failed = request("\"recordings\": \"FAILED\"");
    assertThat(build(failed).get("recordedCases").asString()).isEqualTo("FAILED");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "failed-films", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      assertThat(assignment.getRecordings().getCases()).isEqualTo(RecordingOrder.Cases.FAILED);
      assertRejected(
          Status.Code.INVALID_ARGUMENT, () -> agent.uploadRecording(attempt, 1, new byte[100]));
      assertRejected(
          Status.Code.INVALID_ARGUMENT, () -> agent.uploadRecording(attempt, 0, glb(20, 1)));
      byte[] cut = java.util.Arrays.copyOf(glb(100, 1), 50);
      assertRejected(Status.Code.INVALID_ARGUMENT, () -> agent.uploadRecording(attempt, 1, cut));
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.uploadRecording(attempt, 1, glb(20, 1), StoredFiles.sha256(cut)));
      agent.submit(attempt, FakeAgent.result(agent.download(assignment), List.of()));
      assertRejected(
          Status.Code.FAILED_PRECONDITION, () -> agent.uploadRecording(attempt, 1, glb(20, 1)));
    }
    assertThat(recorded(failed, "CASE")).isEmpty();
    api.post("/api/v1/builds", "{\"suiteId\":\"" + suiteId + "\",\"recordings\":\"SOME\"}")
        .expect(400);
  }

  @Test
  void recordingsOfAnAttemptAreLimited() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "large-films", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      agent.uploadRecording(attempt, 1, glb(700_000, 1));
      agent.uploadRecording(attempt, 2, glb(300_000, 2));
      assertRejected(
          Status.Code.INVALID_ARGUMENT, () -> agent.uploadRecording(attempt, 3, glb(100_000, 3)));
      agent.uploadRecording(attempt, 1, glb(100, 1));
      agent.uploadRecording(attempt, 3, glb(100_000, 3));
    }
    assertThat(recorded(id, "CASE")).containsExactly(1, 2, 3);
  }

  @Test
  void buildHasTheRecordingsOfItsLatestAttemptOnly() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "film-again", "java")) {
      AttemptRef first = agent.nextAssignment().getAttempt();
      agent.uploadRecording(first, 1, glb(100, 1));
      agent.uploadRecording(first, 2, glb(100, 2));
      agent.submit(
          first,
          BuildFailure.newBuilder()
              .setCategory(BuildFailure.Category.INFRASTRUCTURE)
              .setMessage("no simulator")
              .build());
      AttemptRef second = agent.nextAssignment().getAttempt();
      agent.uploadRecording(second, 2, glb(100, 22));
      assertThat(recorded(id, "CASE")).containsExactly(2);
      assertThat(recording(id, 2).expect(200).bytes()).isEqualTo(glb(100, 22));
    }
  }

  @Test
  void buildWithShardsHasAllTheirRecordings() {
    String id = request("\"shards\": 2");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "film-shards", 2, List.of(), "java")) {
      AttemptRef one = agent.nextAssignment().getAttempt();
      AttemptRef other = agent.nextAssignment().getAttempt();
      agent.uploadRecording(one, 5, glb(100, 5));
      agent.uploadRecording(other, 40, glb(100, 40));
      assertThat(recorded(id, "CASE")).containsExactly(5, 40);
      assertThat(recorded(one.getBuildId(), "CASE")).containsExactly(5);
      assertThat(recording(id, 40).expect(200).bytes()).isEqualTo(glb(100, 40));
    }
  }

  @Test
  void recordingsAreDeletedWithTheirBuild() {
    String id = api.build(suiteId);
    byte[] film = glb(64, 4711);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "film-kept", "java")) {
      Assignment assignment = agent.nextAssignment();
      agent.uploadRecording(assignment.getAttempt(), 1, film);
      agent.submit(
          assignment.getAttempt(), FakeAgent.result(agent.download(assignment), List.of()));
    }
    deleteUnreferenced();
    assertThat(recording(id, 1).expect(200).bytes()).isEqualTo(film);
    api.delete("/api/v1/activities/" + activityId).expect(204);
    deleteUnreferenced();
    assertThat(
            jdbc.sql("SELECT COUNT(*) FROM file_content WHERE sha256 = ?")
                .param(StoredFiles.sha256(film))
                .query(Integer.class)
                .single())
        .isZero();
  }

  protected static void assertRejected(Status.Code code, ThrowingCallable call) {
    assertThatThrownBy(call)
        .isInstanceOfSatisfying(
            StatusRuntimeException.class,
            e -> assertThat(e.getStatus().getCode()).as(e.getMessage()).isEqualTo(code));
  }

  void deleteUnreferenced() {
    jdbc.sql("UPDATE file_content SET stored = TIMESTAMP WITH TIME ZONE '2001-01-01 00:00:00Z'")
        .update();
    files.deleteUnreferenced();
  }
}
