package org.sitaf.core.score;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.score.fault.CallFaults;
import org.sitaf.core.score.fault.Fault;
import org.sitaf.core.score.fault.InputFaults;
import org.sitaf.core.score.fault.OutputFaults;
import org.sitaf.core.score.fault.Row;
import org.sitaf.core.suite.SecondRun;
import org.sitaf.core.suite.SecondRuns;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * The faults of a specification and all executions that they need, each different case once. One
 * test application executes them together.
 */
public final class FaultExecutions {
  private static final int MAX_FAULTS = 1_500;
  private static final int PROBE_SHARE = 4;
  private static final int MAX_PROBES = 300;

  private final TestModel model;
  private final TestSuite suite;
  private final List<SecondRun> secondRuns;
  private final List<Fault> faults;
  private final List<Row> rows = new ArrayList<>();
  private final List<Row> secondRows = new ArrayList<>();
  private final List<Row> probes = new ArrayList<>();
  private final Map<List<String>, TestCase> executed = new LinkedHashMap<>();
  private final int ofSuite;
  private int nextNo;

  /**
   * Plans the executions.
   *
   * @param suite with one value for each input of the model
   * @param world of the activity; null if it has none
   * @param recorded the interfaces whose calls the test application records
   * @param budget maximum number of executions beyond the suite and its relations
   */
  public FaultExecutions(
      TestModel model,
      TestSuite suite,
      @Nullable WorldDescription world,
      List<InterfaceDescription> recorded,
      int budget) {
    this.model = model;
    this.suite = suite;
    this.secondRuns = SecondRuns.of(model, suite, world);
    this.nextNo = suite.cases().stream().mapToInt(TestCase::no).max().orElse(0) + 1;
    List<String> before = null;
    for (TestCase testCase : suite.cases()) {
      executed.putIfAbsent(testCase.values(), testCase);
      rows.add(new Row(testCase.values(), before));
      before = testCase.values();
    }
    for (SecondRun run : secondRuns) {
      for (TestCase testCase : run.suite().cases()) {
        execute(testCase.values(), testCase.valid());
        secondRows.add(new Row(testCase.values(), null));
      }
    }
    this.ofSuite = executed.size();
    Probes beyond = new Probes(model, suite, world);
    this.faults = sampled(faults(beyond, world, recorded));
    if (suite.cases().isEmpty()) {
      return;
    }
    for (List<String> row : beyond.rows(Math.min(MAX_PROBES, budget / PROBE_SHARE))) {
      boolean isNew = !executed.containsKey(row);
      execute(row, beyond.isValid(row));
      if (isNew) {
        probes.add(new Row(row, null));
      }
    }
    executeInputFaults(beyond, budget);
  }

  private List<Fault> faults(
      Probes beyond, @Nullable WorldDescription world, List<InterfaceDescription> recorded) {
    List<Fault> all = new ArrayList<>(OutputFaults.of(model, beyond.conditions()));
    if (!suite.cases().isEmpty()) {
      all.addAll(InputFaults.of(model, world, beyond.simplest()));
    }
    all.addAll(CallFaults.of(recorded));
    return all;
  }

  /** Every k-th fault, if there are too many. */
  private static List<Fault> sampled(List<Fault> all) {
    if (all.size() <= MAX_FAULTS) {
      return all;
    }
    List<Fault> some = new ArrayList<>();
    for (int i = 0; i < MAX_FAULTS; i++) {
      some.add(all.get((int) ((long) i * all.size() / MAX_FAULTS)));
    }
    return some;
  }

  /** One case of each fault in turn, so that a small budget is enough for some cases of each. */
  private void executeInputFaults(Probes beyond, int budget) {
    List<Fault.OfInputs> ofInputs =
        faults.stream()
            .filter(Fault.OfInputs.class::isInstance)
            .map(Fault.OfInputs.class::cast)
            .toList();
    List<Row> order = all();
    Collections.shuffle(order, new Random(1));
    for (Row row : order) {
      for (Fault.OfInputs fault : ofInputs) {
        if (executed.size() - ofSuite >= budget) {
          return;
        }
        fault
            .change()
            .apply(row.values(), row.before())
            .ifPresent(changed -> execute(changed, beyond.isValid(changed)));
      }
    }
  }

  private void execute(List<String> values, boolean valid) {
    if (!executed.containsKey(values)) {
      executed.put(values, new TestCase(nextNo++, valid, values, List.of()));
    }
  }

  /** All cases to execute; those of the suite keep their numbers. */
  public TestSuite cases() {
    List<TestCase> all = new ArrayList<>(suite.cases());
    all.addAll(executed.values().stream().skip(suiteRows()).toList());
    return suite.withCases(all);
  }

  private long suiteRows() {
    return suite.cases().stream().map(TestCase::values).distinct().count();
  }

  /** Number of cases beyond the suite. */
  public int further() {
    return executed.size() - (int) suiteRows();
  }

  /** The number of the case with these values; 0 if it is not executed. */
  int number(List<String> values) {
    TestCase testCase = executed.get(values);
    return testCase == null ? 0 : testCase.no();
  }

  List<Fault> faults() {
    return faults;
  }

  List<SecondRun> secondRuns() {
    return secondRuns;
  }

  TestModel model() {
    return model;
  }

  /** The cases beyond the suite that show which faults it never reaches. */
  List<Row> probes() {
    return probes;
  }

  private List<Row> all() {
    List<Row> all = new ArrayList<>(rows);
    all.addAll(secondRows);
    all.addAll(probes);
    return all;
  }
}
