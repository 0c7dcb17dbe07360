package org.sitaf.runtime.simulation.frozen;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.sitaf.runtime.suite.TestCase;
import org.sitaf.sim.v1.CreateSessionResponse;
import org.sitaf.sim.v1.DeviceDescription;
import org.sitaf.sim.v1.PrepareManyRequest;
import org.sitaf.sim.v1.PrepareManyResponse;
import org.sitaf.sim.v1.Range;
import org.sitaf.sim.v1.Reading;
import org.sitaf.sim.v1.WorldDescription;
import org.sitaf.sim.v1.WorldState;

/** Requests for the following cases, and the assignment of responses to cases. */
class PreparationTest {
  private final List<PrepareManyRequest> requests = new ArrayList<>();
  private double rejected = Double.NaN;

  /** A range sensor that reads the value that was set. */
  private static CreateSessionResponse session() {
    return CreateSessionResponse.newBuilder()
        .setWorld(
            WorldDescription.newBuilder()
                .setTimestepNs(1)
                .addDevices(
                    DeviceDescription.newBuilder().setName("r").setKind("range").addFields("m")))
        .setState(
            WorldState.newBuilder()
                .addReadings(
                    Reading.newBuilder().setDevice("r").setRange(Range.getDefaultInstance())))
        .build();
  }

  private Optional<PrepareManyResponse> answer(PrepareManyRequest request) {
    requests.add(request);
    return request.getValuesList().contains(rejected)
        ? Optional.empty()
        : Optional.of(
            PrepareManyResponse.newBuilder()
                .addColumns("r.m")
                .addAllReadings(request.getValuesList())
                .build());
  }

  /** Runs cases with these distances; returns the number of cases with a prepared world. */
  private int run(int count, double... distances) {
    Deque<TestCase> left = new ArrayDeque<>();
    IntStream.range(0, count)
        .mapToObj(i -> Map.of("d", Double.toString(distances[i % distances.length])))
        .forEach(values -> left.add(new TestCase(left.size() + 1, true, values)));
    Preparation preparation =
        new Preparation(
            session(), most -> left.stream().limit(most).toList(), request -> answer(request));
    int known = 0;
    while (!left.isEmpty()) {
      double distance = left.remove().doubleValue("d");
      Optional<FrozenWorld> world = preparation.world(Map.of("d", distance), 0, 0);
      if (world.isPresent()) {
        known++;
        assertThat(world.get().reading("r").getRange().getRangeM()).isEqualTo(distance);
      }
    }
    return known;
  }

  @Test
  void preparesEachCombinationOfValuesOnce() {
    assertThat(run(500, 1, 2, 3, 0.0, -0.0)).isEqualTo(500);

    assertThat(requests).hasSize(1);
    assertThat(requests.get(0).getValuesList()).containsExactly(1.0, 2.0, 3.0, 0.0, -0.0);
    assertThat(requests.get(0).getCases()).isEqualTo(5);
  }

  @Test
  void preparesOneWorldForCasesWithEqualValues() {
    assertThat(run(100, 4)).isEqualTo(100);
    assertThat(requests).hasSize(1);
  }

  @Test
  void leavesASingleCaseToTheSession() {
    assertThat(run(1, 4)).isZero();
    assertThat(requests).isEmpty();
  }

  @Test
  void preparesManyValuesInFewCalls() {
    assertThat(run(3000, IntStream.range(0, 3000).asDoubleStream().toArray())).isEqualTo(3000);
    assertThat(requests.size()).isLessThan(8);
  }

  @Test
  void leavesCasesNextToARejectedOneToTheSession() {
    rejected = 7;
    int known = run(400, IntStream.range(0, 400).asDoubleStream().toArray());

    assertThat(known).isBetween(360, 399);
  }
}
