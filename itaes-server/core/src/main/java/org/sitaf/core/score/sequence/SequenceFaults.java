package org.sitaf.core.score.sequence;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.function.BiPredicate;
import java.util.function.IntPredicate;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.SequenceStep;
import org.sitaf.core.score.Probes;
import org.sitaf.core.score.fault.CallFaults;
import org.sitaf.core.score.fault.Condition;
import org.sitaf.core.score.fault.Fault;
import org.sitaf.core.score.fault.InputFaults;
import org.sitaf.core.score.fault.OutputFaults;
import org.sitaf.core.score.fault.Row;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.StepRecord;

/**
 * The faults of sequences: steps left out, repeated and exchanged, the answer of an earlier call,
 * wrong values after certain steps, and the faults of single calls in each call.
 */
final class SequenceFaults {
  private final TestModel model;
  private final SequenceSpec sequence;
  private final TestSuite suite;
  private final @Nullable WorldDescription world;
  private final Map<String, Target> targets = new LinkedHashMap<>();
  private final List<SequenceFault> faults = new ArrayList<>();

  private SequenceFaults(
      TestModel model, SequenceSpec sequence, TestSuite suite, @Nullable WorldDescription world) {
    this.model = model;
    this.sequence = sequence;
    this.suite = suite;
    this.world = world;
    sequence.calls().forEach(c -> targets.put(c.name(), c.model().target()));
  }

  /**
   * All faults.
   *
   * @param sequence of the model
   * @param world of the activity; null if it has none
   * @param recorded the interfaces whose calls the test application records
   */
  static List<SequenceFault> of(
      TestModel model,
      SequenceSpec sequence,
      TestSuite suite,
      @Nullable WorldDescription world,
      List<InterfaceDescription> recorded) {
    SequenceFaults all = new SequenceFaults(model, sequence, suite, world);
    sequence.steps().forEach(all::ofStep);
    sequence.calls().forEach(all::ofCall);
    all.ofValues();
    for (Fault fault : CallFaults.of(recorded)) {
      all.ofRecord((Fault.OfRecord) fault, "", (testCase, i) -> true);
    }
    return all.faults;
  }

  /** Faults of what reaches the component, and when. */
  private void ofStep(SequenceStep step) {
    String name = step.name();
    leftOut(name, "left out", (at, i) -> true);
    leftOut(name, "first one left out", (at, i) -> at.size() > 1 && i.equals(at.get(0)));
    leftOut(name, "last one left out", (at, i) -> at.size() > 1 && i.equals(at.get(at.size() - 1)));
    if (step instanceof SequenceCall) {
      twice(name, "made twice, the first answer counts", true);
      twice(name, "made twice, the second answer counts", false);
    }
    for (SequenceStep next : sequence.steps()) {
      boolean differ = !next.name().equals(name);
      if (differ && (step instanceof SequenceCall || next instanceof SequenceCall)) {
        faults.add(
            new SequenceFault.OfSteps(
                name,
                name + ": swapped with " + next.name() + " after it",
                (testCase, before) ->
                    changed(
                        testCase,
                        Delivery.exchanged(
                            testCase,
                            (one, other) ->
                                one.name().equals(name) && other.name().equals(next.name())))));
      }
    }
  }

  /**
   * Leaves steps out.
   *
   * @param which over the indices of the steps with this name, and the index of a step among them
   */
  private void leftOut(String name, String text, BiPredicate<List<Integer>, Integer> which) {
    faults.add(
        new SequenceFault.OfSteps(
            name,
            name + ": " + text,
            (testCase, before) -> {
              List<Integer> at = indices(testCase, name);
              return changed(
                  testCase, Delivery.without(testCase, i -> at.contains(i) && which.test(at, i)));
            }));
  }

  private void twice(String name, String text, boolean first) {
    faults.add(
        new SequenceFault.OfSteps(
            name,
            name + ": " + text,
            (testCase, before) -> {
              IntPredicate repeated = i -> testCase.steps().get(i).name().equals(name);
              return changed(testCase, Delivery.twice(testCase, first, repeated));
            }));
  }

  private static List<Integer> indices(TestCase testCase, String name) {
    return IntStream.range(0, testCase.steps().size())
        .filter(i -> testCase.steps().get(i).name().equals(name))
        .boxed()
        .toList();
  }

  private static Optional<Delivery> changed(TestCase testCase, Delivery delivery) {
    return delivery.steps().equals(testCase.steps()) ? Optional.empty() : Optional.of(delivery);
  }

  /** The faults of single calls, in each step that makes the call. */
  private void ofCall(SequenceCall call) {
    String name = call.name();
    BiPredicate<TestCase, Integer> isCall =
        (testCase, i) -> testCase.steps().get(i).name().equals(name);
    Probes probes = new Probes(call.model().withoutOutputs(), rows(name), world);
    for (Fault fault : OutputFaults.of(call.model(), probes.conditions(), "call")) {
      ofRecord((Fault.OfRecord) fault, name, isCall);
    }
    for (SequenceStep other : sequence.steps()) {
      String earlier = other.name();
      under(call, "directly after " + earlier, (c, i) -> i > 0 && is(c, i - 1, earlier));
      under(
          call,
          "after " + earlier + " and other steps",
          (c, i) -> IntStream.range(0, Math.max(0, i - 1)).anyMatch(k -> is(c, k, earlier)));
    }
    if (rows(name).cases().isEmpty()) {
      return;
    }
    for (Fault fault : InputFaults.of(call.model(), world, probes.simplest(), "call")) {
      Fault.OfInputs ofInputs = (Fault.OfInputs) fault;
      faults.add(
          new SequenceFault.OfSteps(
              name + "." + fault.where(),
              name + "." + fault.text(),
              (testCase, before) -> changed(testCase, inputs(testCase, name, ofInputs))));
    }
  }

  private void under(SequenceCall call, String when, BiPredicate<TestCase, Integer> holds) {
    for (Fault fault :
        OutputFaults.under(call.model(), new Condition(when, false, values -> true))) {
      ofRecord(
          (Fault.OfRecord) fault,
          call.name(),
          (testCase, i) -> is(testCase, i, call.name()) && holds.test(testCase, i));
    }
  }

  private static boolean is(TestCase testCase, int index, String name) {
    return testCase.steps().get(index).name().equals(name);
  }

  /** The different rows of a call in the suite as cases of its own. */
  private TestSuite rows(String name) {
    Map<List<String>, TestCase> rows = new LinkedHashMap<>();
    for (TestCase testCase : suite.cases()) {
      for (TestStep step : testCase.steps()) {
        if (step.name().equals(name)) {
          rows.putIfAbsent(
              step.values(), new TestCase(rows.size() + 1, step.valid(), step.values(), List.of()));
        }
      }
    }
    return new TestSuite(
        suite.name(),
        suite.description(),
        suite.modelName(),
        suite.generation(),
        suite.stepParameters(name),
        List.copyOf(rows.values()));
  }

  private Delivery inputs(TestCase testCase, String name, Fault.OfInputs fault) {
    List<TestStep> steps = new ArrayList<>(testCase.steps());
    @Nullable List<String> before = null;
    for (int i = 0; i < steps.size(); i++) {
      TestStep step = steps.get(i);
      if (step.name().equals(name)) {
        Optional<List<String>> values = fault.change().apply(step.values(), before);
        before = step.values();
        if (values.isPresent()) {
          steps.set(i, new TestStep(name, step.valid(), values.get(), List.of()));
        }
      }
    }
    return Delivery.withSteps(testCase, steps);
  }

  /** The faults of what is set before the first step. */
  private void ofValues() {
    if (model.inputs().isEmpty() || suite.cases().isEmpty()) {
      return;
    }
    TestSuite initial =
        new TestSuite(
            suite.name(),
            suite.description(),
            suite.modelName(),
            suite.generation(),
            suite.parameters(),
            suite.cases().stream()
                .map(c -> new TestCase(c.no(), c.valid(), c.values(), List.of()))
                .toList());
    List<String> simplest = new Probes(model.withoutOutputs(), initial, world).simplest();
    for (Fault fault : InputFaults.of(model, world, simplest)) {
      Fault.OfInputs ofInputs = (Fault.OfInputs) fault;
      faults.add(
          new SequenceFault.OfSteps(
              fault.where(),
              fault.text(),
              (testCase, before) ->
                  ofInputs
                      .change()
                      .apply(testCase.values(), before == null ? null : before.values())
                      .map(values -> Delivery.withValues(testCase, values))));
    }
  }

  /** A fault of records in some steps. The record before is that of the same method. */
  private void ofRecord(Fault.OfRecord fault, String call, BiPredicate<TestCase, Integer> where) {
    String prefix = call.isEmpty() ? "" : call + ".";
    faults.add(
        new SequenceFault.OfRecords(
            prefix + fault.where(),
            prefix + fault.text(),
            (testCase, records) -> {
              List<StepRecord> all = new ArrayList<>(records);
              for (int i = 0; i < all.size(); i++) {
                if (where.test(testCase, i)) {
                  StepRecord step = records.get(i);
                  CaseRecord changed =
                      fault
                          .change()
                          .apply(
                              new Row(testCase.steps().get(i).values(), null),
                              step.record(),
                              before(testCase, records, i));
                  all.set(i, step.with(changed));
                }
              }
              return all;
            }));
  }

  /** The record of the latest earlier step that calls the same method; null if there is none. */
  private @Nullable CaseRecord before(TestCase testCase, List<StepRecord> records, int index) {
    Target target = targets.get(testCase.steps().get(index).name());
    for (int i = index - 1; target != null && i >= 0; i--) {
      Target earlier = targets.get(testCase.steps().get(i).name());
      if (earlier != null
          && earlier.method().equals(target.method())
          && Objects.equals(earlier.interfaceName(), target.interfaceName())
          && Objects.equals(earlier.signature(), target.signature())) {
        return records.get(i).record();
      }
    }
    return null;
  }
}
