package org.sitaf.server.story;

import static org.assertj.core.api.Assertions.assertThat;

import io.grpc.Status;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.stream.DoubleStream;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.CaseSignals;
import org.sitaf.agent.v1.ConditionSpan;
import org.sitaf.agent.v1.SampledSignal;
import org.sitaf.server.support.Api;
import org.sitaf.server.support.FakeAgent;
import tools.jackson.databind.JsonNode;

/** Signals of cases, from the upload by an agent to the plot. */
abstract class SignalStory extends RecordingStory {
  private static SampledSignal.Builder signal(String name, double... values) {
    return SampledSignal.newBuilder()
        .setName(name)
        .setUnit("m")
        .addAllValues(Arrays.stream(values).boxed().toList());
  }

  private static CaseSignals.Builder signals(double... values) {
    return CaseSignals.newBuilder()
        .setSamples(values.length)
        .addAllTimesNs(LongStream.range(0, values.length).mapToObj(k -> k * 500_000_000L).toList())
        .addSignals(signal("robot_x", values))
        .addConditions(
            ConditionSpan.newBuilder()
                .setName("never touches")
                .setToNs(1_000_000_000)
                .addSignals("robot_x"));
  }

  private Api.Answer signalsOf(String build, int caseNo) {
    return api.get("/api/v1/builds/" + build + "/cases/" + caseNo + "/signals");
  }

  private static List<Double> numbers(JsonNode array) {
    return array.valueStream().map(n -> n.isNull() ? Double.NaN : n.asDouble()).toList();
  }

  @Test
  void signalsAreAvailableDuringAndAfterTheBuild() {
    // Signals of violated conditions are stored without recordings, too.
    String id = request("\"recordings\": \"NONE\"");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "plots", "java")) {
      Assignment assignment = agent.nextAssignment();
      assertThat(assignment.getSignals().getMaxCases()).isEqualTo(500);
      assertThat(assignment.getSignals().getMaxBytes()).isEqualTo(100L << 10);
      AttemptRef attempt = assignment.getAttempt();
      signalsOf(id, 3).expect(204);
      CaseSignals first = signals(1, Double.POSITIVE_INFINITY, 2.5).setSamples(2000).build();
      agent.uploadSignals(attempt, 3, signals(4).build());
      agent.uploadSignals(attempt, 3, first);
      signalsOf(id, 3).expect(200);
      agent.submit(attempt, FakeAgent.result(agent.download(assignment), List.of()));
    }
    Api.Answer answer = signalsOf(id, 3).expect(200);
    JsonNode found = answer.json();
    assertThat(found.get("samples").asInt()).isEqualTo(2000);
    assertThat(numbers(found.get("times"))).containsExactly(0.0, 0.5, 1.0);
    JsonNode signal = found.get("signals").get(0);
    assertThat(signal.get("name").asString()).isEqualTo("robot_x");
    assertThat(signal.get("unit").asString()).isEqualTo("m");
    assertThat(numbers(signal.get("values"))).containsExactly(1.0, Double.NaN, 2.5);
    JsonNode condition = found.get("conditions").get(0);
    assertThat(condition.get("name").asString()).isEqualTo("never touches");
    assertThat(condition.get("to").asDouble()).isEqualTo(1);
    assertThat(condition.get("signals").get(0).asString()).isEqualTo("robot_x");
    String etag = answer.headers().firstValue("ETag").orElseThrow();
    String path = "/api/v1/builds/" + id + "/cases/3/signals";
    assertThat(api.send(api.request(path).header("If-None-Match", etag).GET()).status())
        .isEqualTo(304);
    signalsOf(id, 4).expect(204);
    signalsOf("none", 3).expect(404);
  }

  @Test
  void contradictorySignalsAreRejected() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "wrong-plots", "java")) {
      Assignment assignment = agent.nextAssignment();
      AttemptRef attempt = assignment.getAttempt();
      List<Consumer<CaseSignals.Builder>> changes =
          List.of(
              CaseSignals.Builder::clear,
              s -> s.setSamples(1),
              s -> s.setTimesNs(1, 0),
              s -> s.setTimesNs(2, Long.MAX_VALUE),
              CaseSignals.Builder::clearSignals,
              s -> s.addSignals(signal("robot_x", 1, 2, 3)),
              s -> s.addSignals(signal("short", 1)),
              s -> s.addSignals(signal("", 1, 2, 3)),
              s -> s.addSignals(signal("a\nb", 1, 2, 3)),
              s -> s.addSignals(signal("x".repeat(301), 1, 2, 3)),
              s -> s.addSignals(signal("y", 1, 2, 3).setUnit("u".repeat(21))),
              s -> s.getConditionsBuilder(0).addSignals("other"),
              s -> s.getConditionsBuilder(0).setToNs(-1),
              s -> s.getConditionsBuilder(0).setName(""));
      for (Consumer<CaseSignals.Builder> change : changes) {
        CaseSignals.Builder changed = signals(1, 2, 3);
        change.accept(changed);
        assertRejected(
            Status.Code.INVALID_ARGUMENT, () -> agent.uploadSignals(attempt, 1, changed.build()));
      }
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.uploadSignals(attempt, 0, signals(1, 2, 3).build()));
      double[] tooMany = new double[20_001];
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.uploadSignals(attempt, 1, signals(tooMany).build()));
      signalsOf(id, 1).expect(204);
      agent.submit(attempt, FakeAgent.result(agent.download(assignment), List.of()));
      assertRejected(
          Status.Code.FAILED_PRECONDITION,
          () -> agent.uploadSignals(attempt, 1, signals(1, 2, 3).build()));
    }
  }

  @Test
  void signalsOfAnAttemptAreLimited() {
    String id = api.build(suiteId);
    Random random = new Random(1);
    double[] noise = DoubleStream.generate(random::nextDouble).limit(6_000).toArray();
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "large-plots", "java")) {
      AttemptRef attempt = agent.nextAssignment().getAttempt();
      agent.uploadSignals(attempt, 1, signals(noise).build());
      assertRejected(
          Status.Code.INVALID_ARGUMENT,
          () -> agent.uploadSignals(attempt, 2, signals(noise).build()));
      agent.uploadSignals(attempt, 1, signals(1, 2).build());
      agent.uploadSignals(attempt, 2, signals(noise).build());
    }
    signalsOf(id, 2).expect(200);
  }

  @Test
  void buildHasTheSignalsOfItsLatestAttemptAndOfItsShards() {
    String id = request("\"shards\": 2");
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "plot-shards", 2, List.of(), "java")) {
      AttemptRef one = agent.nextAssignment().getAttempt();
      AttemptRef other = agent.nextAssignment().getAttempt();
      agent.uploadSignals(one, 5, signals(5).build());
      agent.uploadSignals(other, 40, signals(40).build());
      signalsOf(id, 5).expect(200);
      signalsOf(id, 40).expect(200);
      agent.submit(
          one,
          BuildFailure.newBuilder()
              .setCategory(BuildFailure.Category.INFRASTRUCTURE)
              .setMessage("no simulator")
              .build());
      AttemptRef again = agent.nextAssignment().getAttempt();
      assertThat(again.getBuildId()).isEqualTo(one.getBuildId());
      signalsOf(id, 5).expect(204);
    }
  }

  @Test
  void signalsAreDeletedWithTheirBuild() {
    String id = api.build(suiteId);
    try (FakeAgent agent = FakeAgent.register(grpcPort(), "plot-kept", "java")) {
      Assignment assignment = agent.nextAssignment();
      agent.uploadSignals(assignment.getAttempt(), 1, signals(0.4711).build());
      agent.submit(
          assignment.getAttempt(), FakeAgent.result(agent.download(assignment), List.of()));
    }
    deleteUnreferenced();
    signalsOf(id, 1).expect(200);
    String sha256 =
        jdbc.sql(
                "SELECT s.sha256 FROM case_signals s JOIN attempt a ON a.token = s.token"
                    + " WHERE a.build_id = ?")
            .param(id)
            .query(String.class)
            .single();
    api.delete("/api/v1/activities/" + activityId).expect(204);
    deleteUnreferenced();
    assertThat(
            jdbc.sql("SELECT COUNT(*) FROM file_content WHERE sha256 = ?")
                .param(sha256)
                .query(Integer.class)
                .single())
        .isZero();
  }
}
