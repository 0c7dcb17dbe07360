package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.build.RecordingOrder.Cases;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.Device;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.trajectory.ConditionSpan;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TrajectoryResult;
import org.sitaf.core.verdict.Verdict;

class KeptSignalsTest {
  private static final long STEP_NANOS = 1_000_000;
  private static final List<String> NAMES = List.of("base.linear", "bumped", "robot_x");

  private static final WorldDescription WORLD =
      new WorldDescription(
          "w.world.yaml",
          List.of(),
          List.of(new Device("base", "differential_drive")),
          List.of("bumped", "robot_x"));

  private final Map<Integer, SignalExcerpt> excerpts = new TreeMap<>();
  private final List<String> remarks = new ArrayList<>();

  private KeptSignals keeping(@Nullable Cases recorded, int cases, long bytes) {
    return new KeptSignals(
        new SignalLimits(cases, bytes), recorded, WORLD, conditions(), listener());
  }

  private BuildListener listener() {
    return new BuildListener() {
      @Override
      public void stage(BuildStage stage) {}

      @Override
      public void log(byte[] utf8) {}

      @Override
      public void caseFinished(CaseResult result) {}

      @Override
      public void recorded(int no, Path recording) {}

      @Override
      public void signalsKept(int no, SignalExcerpt signals) {
        excerpts.put(no, signals);
      }
    };
  }

  private static TrajectoryConditions conditions() {
    String model =
        """
        <test_model><name>Model</name><description/><input_spec_list/>
        <trajectory_condition_spec_list>
        <trajectory_condition name="never touches">always(bumped == 0.0)</trajectory_condition>
        <trajectory_condition name="stops">eventually[0.5, 2](base.linear == 0.0)
        </trajectory_condition></trajectory_condition_spec_list>
        <order_of_combinations>1</order_of_combinations></test_model>
        """;
    return TrajectoryConditions.compile(
        TestModelXml.read(
            new ByteArrayInputStream(model.getBytes(StandardCharsets.UTF_8)), "Model.xml"),
        NAMES,
        60,
        new Diagnostics());
  }

  private static CaseResult result(int no, Verdict verdict, TrajectoryResult... trajectories) {
    return new CaseResult(no, verdict, List.of(), List.of(), List.of(), null, "")
        .with(List.of(trajectories));
  }

  private static Trace trace(int count) {
    double[] bumped = new double[count];
    bumped[count / 3] = 1;
    return new Trace(0, STEP_NANOS, NAMES, List.of(new double[count], bumped, new double[count]));
  }

  private List<String> report(KeptSignals signals) {
    signals.report(
        new OutputSink() {
          @Override
          public void output(String text, int caseNo) {}

          @Override
          public void remark(String line) {
            remarks.add(line);
          }
        });
    return remarks;
  }

  @Test
  void keepsTheSignalsOfTheConditionsWithUnitsAndSpans() {
    KeptSignals signals = keeping(Cases.ALL, 10, 1 << 20);
    signals.add(result(1, Verdict.PASS), trace(1001));

    SignalExcerpt kept = excerpts.get(1);
    assertThat(kept.samples()).isEqualTo(1001);
    assertThat(kept.nanos()).hasSize(1001).startsWith(0, STEP_NANOS);
    assertThat(kept.signals())
        .extracting(SignalExcerpt.Signal::name)
        .containsExactly("base.linear", "bumped");
    assertThat(kept.signals().get(0).unit()).isEqualTo("m/s");
    assertThat(kept.signals().get(1).unit()).isEmpty();
    assertThat(kept.signals().get(1).values()[333]).isEqualTo(1);
    assertThat(kept.conditions())
        .containsExactly(
            new ConditionSpan("never touches", 0, 1_000_000_000, List.of("bumped")),
            new ConditionSpan("stops", 500_000_000, 1_000_000_000, List.of("base.linear")));
    assertThat(excerpts.keySet()).containsExactly(1);
    assertThat(report(signals)).containsExactly("signals: 1 cases, 0.0 MiB");
  }

  @Test
  void keepsTheExtremesOfAListThatAConditionUsesAsAWhole() {
    int rays = 300;
    WorldDescription world =
        new WorldDescription(
            "w.world.yaml",
            List.of(),
            List.of(new Device("lidar", "laser_scan", Device.DEFAULT_RATE_HZ, rays)),
            List.of());
    String model =
        """
        <test_model><name>Model</name><description/><input_spec_list/>
        <trajectory_condition_spec_list>
        <trajectory_condition name="clear">always(min(lidar.ranges) > 0.5 || lidar.ranges[7] > 2.0)
        </trajectory_condition></trajectory_condition_spec_list>
        <order_of_combinations>1</order_of_combinations></test_model>
        """;
    TrajectoryConditions clear =
        TrajectoryConditions.compile(
            TestModelXml.read(
                new ByteArrayInputStream(model.getBytes(StandardCharsets.UTF_8)), "Model.xml"),
            List.of(),
            WorldSignals.lists(world),
            60,
            new Diagnostics());
    List<double[]> columns = new ArrayList<>();
    for (int ray = 0; ray < rays; ray++) {
      columns.add(new double[] {1 + ray, 0.4 + ray});
    }
    List<String> names =
        java.util.stream.IntStream.range(0, rays).mapToObj(i -> "lidar.ranges[" + i + "]").toList();
    new KeptSignals(new SignalLimits(10, 1 << 20), Cases.ALL, world, clear, listener())
        .add(result(1, Verdict.FAIL), new Trace(0, STEP_NANOS, names, columns));

    SignalExcerpt kept = excerpts.get(1);
    assertThat(kept.signals())
        .extracting(SignalExcerpt.Signal::name)
        .containsExactly("lidar.ranges[7]", "max(lidar.ranges)", "min(lidar.ranges)");
    assertThat(kept.signals()).extracting(SignalExcerpt.Signal::unit).containsOnly("m");
    assertThat(kept.signals().get(1).values()).containsExactly(300, 299.4);
    assertThat(kept.signals().get(2).values()).containsExactly(1, 0.4);
    assertThat(kept.conditions().get(0).signals())
        .containsExactlyInAnyOrderElementsOf(
            kept.signals().stream().map(SignalExcerpt.Signal::name).toList());
  }

  @Test
  void aLongCaseKeepsItsPeakAndTheMomentOfTheVerdict() {
    int count = 300_000;
    keeping(Cases.ALL, 10, 1 << 20)
        .add(
            result(
                1,
                Verdict.FAIL,
                new TrajectoryResult("never touches", Verdict.FAIL, -1.0, 123.457)),
            trace(count));

    SignalExcerpt kept = excerpts.get(1);
    assertThat(kept.samples()).isEqualTo(count);
    assertThat(kept.nanos()).hasSizeLessThan(10_010);
    assertThat(kept.nanos())
        .contains(0, 123_457_000_000L, (count - 1) * STEP_NANOS, count / 3 * STEP_NANOS);
    assertThat(kept.signals().get(1).values()).contains(1.0);
  }

  @Test
  void withoutRecordingsOnlyCasesThatViolateAConditionAreKept() {
    KeptSignals signals = keeping(null, 10, 1 << 20);
    TrajectoryResult holds = new TrajectoryResult("stops", Verdict.PASS, 1.0, 2.0);
    signals.add(result(1, Verdict.PASS, holds), trace(10));
    signals.add(result(2, Verdict.FAIL, holds), trace(10));
    signals.add(
        result(3, Verdict.FAIL, new TrajectoryResult("stops", Verdict.FAIL, -1.0, 0.005)),
        trace(10));

    assertThat(excerpts.keySet()).containsExactly(3);
  }

  @Test
  void recordedCasesAreKept() {
    KeptSignals signals = keeping(Cases.FAILED, 10, 1 << 20);
    signals.add(result(1, Verdict.PASS), trace(10));
    signals.add(result(2, Verdict.ERROR), trace(10));

    assertThat(excerpts.keySet()).containsExactly(2);
  }

  @Test
  void logsOmittedCases() {
    KeptSignals signals = keeping(Cases.ALL, 2, 1 << 20);
    for (int no = 1; no <= 5; no++) {
      signals.add(result(no, Verdict.PASS), trace(100));
    }

    assertThat(excerpts.keySet()).containsExactly(1, 2);
    assertThat(report(signals))
        .containsExactly(
            "signals: 2 cases, 0.0 MiB; 3 more are omitted: a build keeps 2 of at most 1 MiB");
  }

  @Test
  void theSizeIsLimited() {
    KeptSignals signals = keeping(Cases.ALL, 10, 1000);
    signals.add(result(1, Verdict.PASS), trace(10_000));
    signals.add(result(2, Verdict.PASS), trace(10));

    assertThat(excerpts.keySet()).containsExactly(2);
  }
}
