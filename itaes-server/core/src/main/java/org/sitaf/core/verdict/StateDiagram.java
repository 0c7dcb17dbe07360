package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.combine.Interruption;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.sequence.AbstractState;
import org.sitaf.core.suite.sequence.SequenceVerification;
import org.sitaf.core.suite.sequence.StepStates;
import org.sitaf.core.verdict.StepResult.Kind;

/**
 * The abstract states of a model and the steps between them: those that the cases of a result
 * executed, and those that are allowed with the same values but were not executed.
 *
 * @param states the initial one first, then in the order in which they are reached
 * @param isComplete false if the model has more states than the diagram
 */
public record StateDiagram(List<State> states, List<Transition> transitions, boolean isComplete) {
  /** More states cannot be read in a diagram. */
  static final int MAX_STATES = 60;

  private static final int MAX_TRANSITIONS = 600;

  /** Limits the exploration, with the number of states. */
  private static final int MAX_STEPS = 500;

  /**
   * An abstract state.
   *
   * @param name {@code enabled=true, near=false}
   * @param steps number of executed steps that began in it
   */
  public record State(String name, int steps) {}

  /**
   * A step from a state to a state.
   *
   * @param from index of the state before it
   * @param to index of the state after it
   * @param passed number of executions that passed
   * @param failed number of executions that decided the verdict of their case
   * @param failedCase number of the first such case; null if there is none
   */
  public record Transition(
      int from,
      int to,
      String step,
      Kind kind,
      int passed,
      int failed,
      @Nullable Integer failedCase) {
    /** Whether a case executed it. */
    public boolean isCovered() {
      return passed + failed > 0;
    }
  }

  public StateDiagram {
    states = List.copyOf(states);
    transitions = List.copyOf(transitions);
  }

  private record Key(String from, String to, String step, Kind kind) {}

  private static final class Count {
    private int passed;
    private int failed;
    private @Nullable Integer failedCase;
  }

  /**
   * The diagram of a result; empty if the model has no sequence.
   *
   * @param seed of the suite
   */
  public static Optional<StateDiagram> of(TestModel model, List<CaseResult> cases, long seed) {
    SequenceSpec sequence = model.sequence();
    if (sequence == null) {
      return Optional.empty();
    }
    Drawing drawing = new Drawing(model, sequence, seed);
    drawing.explore(stepsOf(sequence, cases), false);
    cases.forEach(drawing::execute);
    return Optional.of(drawing.draw());
  }

  /**
   * The diagram of a model without a result: what its sequences may do with the values of its
   * calls, and the forbidden calls that they try. Nothing in it is covered.
   *
   * @param seed of the values
   * @return empty if the model has no sequence or has errors
   */
  public static Optional<StateDiagram> planned(TestModel model, long seed) {
    SequenceSpec sequence = model.sequence();
    if (sequence == null) {
      return Optional.empty();
    }
    return SequenceVerification.steps(model, seed)
        .map(
            steps -> {
              Drawing drawing = new Drawing(model, sequence, seed);
              drawing.explore(new LinkedHashSet<>(steps), true);
              return drawing.draw();
            });
  }

  /** The valid steps of a suite, each once, and all events. */
  private static Set<TestStep> stepsOf(SequenceSpec sequence, List<CaseResult> cases) {
    Set<TestStep> steps = new LinkedHashSet<>();
    sequence.events().forEach(e -> steps.add(new TestStep(e.name(), true, List.of(), List.of())));
    for (CaseResult testCase : cases) {
      for (StepResult step : testCase.steps()) {
        if (step.kind() == Kind.VALID) {
          steps.add(new TestStep(step.name(), true, step.values(), List.of()));
        }
      }
    }
    return steps;
  }

  /** Collects states and transitions. */
  private static final class Drawing {
    private final SequenceSpec sequence;
    private final StepStates states;
    private final Map<String, Integer> known = new LinkedHashMap<>();
    private final Map<Key, Count> transitions = new LinkedHashMap<>();
    private boolean complete = true;

    Drawing(TestModel model, SequenceSpec sequence, long seed) {
      this.sequence = sequence;
      this.states = new StepStates(model, seed);
    }

    StateDiagram draw() {
      List<String> names = known.keySet().stream().limit(MAX_STATES).toList();
      Map<String, Integer> index = new HashMap<>();
      names.forEach(name -> index.put(name, index.size()));
      List<Transition> drawn =
          transitions.entrySet().stream()
              .filter(
                  t -> index.containsKey(t.getKey().from()) && index.containsKey(t.getKey().to()))
              .map(t -> transition(t.getKey(), t.getValue(), index))
              .sorted(Comparator.comparing(t -> t.failed() > 0 ? 0 : t.isCovered() ? 1 : 2))
              .limit(MAX_TRANSITIONS)
              .toList();
      return new StateDiagram(
          names.stream().map(n -> new State(n, Objects.requireNonNull(known.get(n)))).toList(),
          drawn,
          complete && names.size() == known.size() && drawn.size() == transitions.size());
    }

    private static Transition transition(Key key, Count count, Map<String, Integer> index) {
      return new Transition(
          Objects.requireNonNull(index.get(key.from())),
          Objects.requireNonNull(index.get(key.to())),
          key.step(),
          key.kind(),
          count.passed,
          count.failed,
          count.failedCase);
    }

    /**
     * Adds what the model allows with the values of some steps.
     *
     * @param withForbidden whether to add the calls that are tried where their guards are false
     */
    void explore(Set<TestStep> all, boolean withForbidden) {
      List<TestStep> steps = all.stream().limit(MAX_STEPS).toList();
      complete = steps.size() == all.size();
      List<AbstractState> reached = new ArrayList<>(List.of(states.initial()));
      Set<AbstractState> seen = new HashSet<>(reached);
      known.put(states.text(states.initial()), 0);
      int from = 0;
      for (int depth = 0; depth < sequence.length() && from < reached.size(); depth++) {
        for (int to = reached.size(); from < to; from++) {
          Interruption.check();
          AbstractState before = reached.get(from);
          for (TestStep step : steps) {
            Optional<AbstractState> after = states.planned(before, step);
            if (after.isEmpty()) {
              if (withForbidden && states.isForbidden(before, step)) {
                add(before, before, step, Kind.FORBIDDEN);
              }
              continue;
            }
            if (!seen.contains(after.get())) {
              if (reached.size() >= MAX_STATES) {
                complete = false;
                continue;
              }
              seen.add(after.get());
              reached.add(after.get());
              known.put(states.text(after.get()), 0);
            }
            add(before, after.get(), step, Kind.VALID);
          }
        }
      }
    }

    private void add(AbstractState before, AbstractState after, TestStep step, Kind kind) {
      transitions.computeIfAbsent(
          new Key(states.text(before), states.text(after), step.name(), kind), key -> new Count());
    }

    void execute(CaseResult testCase) {
      for (StepResult step : testCase.steps()) {
        if (step.before() == null || step.after() == null || step.verdict() == Verdict.DONT) {
          continue;
        }
        known.merge(step.before(), 1, Integer::sum);
        known.putIfAbsent(step.after(), 0);
        Count count =
            transitions.computeIfAbsent(
                new Key(step.before(), step.after(), step.name(), step.kind()), key -> new Count());
        if (step.verdict() == Verdict.PASS) {
          count.passed++;
        } else if (step.decides()) {
          count.failed++;
          count.failedCase =
              count.failedCase == null
                  ? testCase.no()
                  : Integer.valueOf(Math.min(count.failedCase, testCase.no()));
        }
      }
    }
  }
}
