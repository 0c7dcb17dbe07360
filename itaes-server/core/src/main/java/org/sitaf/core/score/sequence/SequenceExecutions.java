package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

/**
 * The faults of a specification with sequences, and all executions that they need, each different
 * sequence once. One test application executes them together.
 */
public final class SequenceExecutions {
  private static final int MAX_FAULTS = 1_500;
  private static final int PROBE_SHARE = 20;
  private static final int MAX_PROBES = 10;

  /** A probe after two cases of the suite, so that a small budget reaches both. */
  private static final int PROBE_EVERY = 3;

  private final TestModel model;
  private final TestSuite suite;
  private final List<SequenceFault> faults = new ArrayList<>();
  private final Map<Sequence, TestCase> executed = new LinkedHashMap<>();
  private final List<TestCase> probes = new ArrayList<>();
  private final Map<Integer, TestCase> before = new LinkedHashMap<>();
  private final Set<SequenceFault> incomplete = new HashSet<>();
  private int nextNo;
  private int further;
  private int notExecuted;

  /** What decides whether two executions are the same. */
  private record Sequence(List<String> values, List<TestStep> steps) {
    static Sequence of(List<String> values, List<TestStep> steps) {
      return new Sequence(
          values,
          steps.stream().map(s -> new TestStep(s.name(), true, s.values(), List.of())).toList());
    }
  }

  /**
   * Plans the executions.
   *
   * @param model with a sequence
   * @param world of the activity; null if it has none
   * @param recorded the interfaces whose calls the test application records
   * @param budget maximum number of executions beyond the suite
   */
  public SequenceExecutions(
      TestModel model,
      TestSuite suite,
      @Nullable WorldDescription world,
      List<InterfaceDescription> recorded,
      int budget) {
    this.model = model;
    this.suite = suite;
    SequenceSpec sequence = Objects.requireNonNull(model.sequence());
    @Nullable TestCase last = null;
    for (TestCase testCase : suite.cases()) {
      executed.putIfAbsent(Sequence.of(testCase.values(), testCase.steps()), testCase);
      if (last != null) {
        before.put(testCase.no(), last);
      }
      last = testCase;
    }
    int firstNo = suite.cases().stream().mapToInt(TestCase::no).max().orElse(0) + 1;
    int count = Math.min(MAX_PROBES, budget / PROBE_SHARE);
    for (TestCase probe : new SequenceProbes(model, sequence, suite).cases(count, firstNo)) {
      if (executed.putIfAbsent(Sequence.of(probe.values(), probe.steps()), probe) == null) {
        probes.add(probe);
        further++;
      }
    }
    nextNo = firstNo + count;
    plan(SequenceFaults.of(model, sequence, suite, world, recorded), budget);
  }

  /** Faults of records need no execution; each of the others gets one case in turn. */
  private void plan(List<SequenceFault> all, int budget) {
    List<TestCase> order = new ArrayList<>(suite.cases());
    Collections.shuffle(order, new Random(1));
    for (int i = 0; i < probes.size(); i++) {
      order.add(Math.min(order.size(), PROBE_EVERY * (i + 1) - 1), probes.get(i));
    }
    Map<SequenceFault, List<Delivery>> deliveries = new LinkedHashMap<>();
    for (SequenceFault fault : sampled(all)) {
      if (fault instanceof SequenceFault.OfSteps ofSteps) {
        List<Delivery> possible =
            order.stream()
                .map(c -> ofSteps.change().apply(c, before.get(c.no())))
                .flatMap(Optional::stream)
                .toList();
        if (!possible.isEmpty()) {
          deliveries.put(fault, possible);
        }
      } else {
        faults.add(fault);
      }
    }
    Set<SequenceFault> covered = new HashSet<>();
    int rounds = deliveries.values().stream().mapToInt(List::size).max().orElse(0);
    for (int round = 0; round < rounds; round++) {
      for (Map.Entry<SequenceFault, List<Delivery>> each : deliveries.entrySet()) {
        if (round < each.getValue().size()) {
          if (execute(each.getValue().get(round), budget)) {
            covered.add(each.getKey());
          } else {
            incomplete.add(each.getKey());
          }
        }
      }
    }
    notExecuted = deliveries.size() - covered.size();
    deliveries.keySet().stream().filter(covered::contains).forEach(faults::add);
  }

  /** Every k-th fault, if there are too many. */
  private static List<SequenceFault> sampled(List<SequenceFault> all) {
    if (all.size() <= MAX_FAULTS) {
      return all;
    }
    List<SequenceFault> some = new ArrayList<>();
    for (int i = 0; i < MAX_FAULTS; i++) {
      some.add(all.get((int) ((long) i * all.size() / MAX_FAULTS)));
    }
    return some;
  }

  /** Whether the records of a delivery will be known. */
  private boolean execute(Delivery delivery, int budget) {
    Sequence sequence = Sequence.of(delivery.values(), delivery.steps());
    if (delivery.steps().isEmpty() || executed.containsKey(sequence)) {
      return true;
    }
    if (further >= budget) {
      return false;
    }
    further++;
    executed.put(
        sequence,
        new TestCase(
            nextNo++,
            false,
            delivery.values(),
            List.of(),
            delivery.steps().stream().map(TestStep::withoutExpected).toList()));
    return true;
  }

  /** All cases to execute; those of the suite keep their numbers. */
  public TestSuite cases() {
    Set<Integer> ofSuite = new HashSet<>();
    suite.cases().forEach(c -> ofSuite.add(c.no()));
    List<TestCase> all = new ArrayList<>(suite.cases());
    executed.values().stream().filter(c -> !ofSuite.contains(c.no())).forEach(all::add);
    return suite.withCases(all);
  }

  /** Number of cases beyond the suite. */
  public int further() {
    return further;
  }

  /** Number of faults that the budget leaves out. */
  int notExecuted() {
    return notExecuted;
  }

  /** Whether the budget leaves cases out that the fault changes. */
  boolean isIncomplete(SequenceFault fault) {
    return incomplete.contains(fault);
  }

  /** The number of the case with these steps; 0 if it is not executed. */
  int number(List<String> values, List<TestStep> steps) {
    TestCase testCase = executed.get(Sequence.of(values, steps));
    return testCase == null ? 0 : testCase.no();
  }

  /** The case before in the suite; null if there is none. */
  @Nullable TestCase before(TestCase testCase) {
    return before.get(testCase.no());
  }

  List<SequenceFault> faults() {
    return faults;
  }

  TestModel model() {
    return model;
  }

  /** The cases beyond the suite that show which faults it never reaches. */
  List<TestCase> probes() {
    return probes;
  }
}
