package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.KeptCase;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceEvent;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.StateUpdate;
import org.sitaf.core.model.sequence.StateVariable;
import org.sitaf.schemas.CaseType;
import org.sitaf.schemas.ConditionType;
import org.sitaf.schemas.ExpectedFormulaType;
import org.sitaf.schemas.SequenceCallType;
import org.sitaf.schemas.SequenceEventType;
import org.sitaf.schemas.SequenceSpecType;
import org.sitaf.schemas.StateType;
import org.sitaf.schemas.StateUpdateType;
import org.sitaf.schemas.TargetType;

/** Reads the {@code sequence_spec} of a model. */
final class SequenceReader {
  private static final int MAX_LENGTH = 200;
  private static final int MAX_ORDER = 6;
  private static final int MAX_THREADS = 16;
  private static final int MAX_STEPS = 200;
  private static final int MAX_STATES = 50;

  private final Problems problems;
  private final TestModel model;
  private final Map<String, DataType> surroundings = new LinkedHashMap<>();

  /**
   * @param model the rest of the document
   */
  SequenceReader(Problems problems, TestModel model) {
    this.problems = problems;
    this.model = model;
  }

  /** The model with its sequences and the sequences to keep. */
  TestModel read(SequenceSpecType spec, @Nullable TargetType target, List<CaseType> cases) {
    int line = XmlDocuments.line(spec);
    refuseOthers(target);
    int length = number(spec.getLength(), "length", MAX_LENGTH, line);
    int order = number(spec.getOrder(), "order", MAX_ORDER, line);
    boolean repeat = flag(spec.getRepeat(), true, "sequence_spec/repeat", line);
    int threads =
        spec.getThreads() == null ? 1 : number(spec.getThreads(), "threads", MAX_THREADS, line);
    List<StateVariable> states = states(spec.getStates());
    states.forEach(s -> surroundings.put(s.name(), s.type()));
    surroundings.put(SequenceSpec.STEP, new DataType.Scalar(ScalarType.INT32));
    List<SequenceCall> calls = new ArrayList<>();
    spec.getCalls().forEach(c -> call(c).ifPresent(calls::add));
    List<SequenceEvent> events = new ArrayList<>();
    spec.getEvents().forEach(e -> event(e).ifPresent(events::add));
    verifyNames(states, calls, events);
    int steps = spec.getCalls().size() + spec.getEvents().size();
    if (spec.getCalls().isEmpty() || steps > MAX_STEPS) {
      problems.error(
          line,
          "sequence_spec",
          "needs a call, and at most "
              + MAX_STEPS
              + " calls and events; it has "
              + spec.getCalls().size()
              + " calls and "
              + spec.getEvents().size()
              + " events");
    }
    if (order > length) {
      problems.error(
          line,
          "sequence_spec/order",
          "no sequence of "
              + length
              + " steps holds "
              + order
              + "; increase length or reduce order");
    } else if (!repeat && order > steps && steps > 0) {
      problems.error(
          line,
          "sequence_spec/order",
          "there are no "
              + order
              + " distinct steps among "
              + steps
              + "; reduce order or remove repeat=\"false\"");
    }
    boolean valid = length > 0 && order > 0 && order <= length && threads > 0;
    SequenceSpec sequence =
        valid
            ? new SequenceSpec(length, order, repeat, threads, states, calls, events, line)
            : null;
    Map<String, List<InputElement>> inputs = new LinkedHashMap<>();
    calls.forEach(c -> inputs.put(c.name(), c.model().inputs()));
    events.forEach(e -> inputs.put(e.name(), List.of()));
    List<KeptCase> kept = new KeptCaseReader(problems).read(cases, model.inputs(), inputs);
    return model.withSequence(sequence).withKeptCases(kept);
  }

  /** Parts of a model that have no effect on sequences. */
  private void refuseOthers(@Nullable TargetType target) {
    if (target != null && (target.getMethod() != null || target.getSignature() != null)) {
      problems.error(
          XmlDocuments.line(target),
          "target",
          "method and signature have no effect with a sequence_spec; write them at its calls");
    }
    for (OutputElement output : model.outputs()) {
      problems.error(
          output.line(),
          "output_spec_list",
          "has no effect with a sequence_spec; write it in a call, or a post_condition over steps");
    }
    if (!model.relations().isEmpty()) {
      problems.error(
          model.relations().get(0).line(),
          "relation_list",
          "relations compare single calls; remove them or the sequence_spec");
    }
    if (model.timing() != null) {
      problems.error(
          model.timing().line(), "timing", "repeats single calls; remove it or the sequence_spec");
    }
    if (model.maxCases() != TestModel.UNBOUNDED) {
      problems.error(
          0,
          "max_cases",
          "does not bound sequences; remove it, and reduce order or increase length for fewer cases");
    }
  }

  private List<StateVariable> states(List<StateType> given) {
    List<StateVariable> states = new ArrayList<>();
    if (given.size() > MAX_STATES) {
      problems.error(
          XmlDocuments.line(given.get(0)),
          "state",
          "there are " + given.size() + " variables, but at most " + MAX_STATES + " are allowed");
      return states;
    }
    for (StateType state : given) {
      int line = XmlDocuments.line(state);
      String where = "state " + text(state.getName());
      if (state.getType() == null || state.getInitial() == null) {
        problems.error(line, where, "needs a name, a type and an initial value");
        continue;
      }
      DataType type = TypeGrammar.parse(state.getType()).type();
      if (type.isVoid()) {
        problems.error(
            line,
            where,
            "the type must be boolean, a number, string, or a type of the interfaces, not "
                + state.getType());
        continue;
      }
      problems
          .attempt(line, where + "/initial", () -> Value.parse(state.getInitial(), type))
          .ifPresent(
              initial ->
                  states.add(
                      new StateVariable(
                          text(state.getName()), state.getType(), type, initial, line)));
    }
    return states;
  }

  private Optional<SequenceCall> call(SequenceCallType given) {
    int line = XmlDocuments.line(given);
    String name = text(given.getName() == null ? given.getMethod() : given.getName());
    String where = "call " + name;
    ElementListReader elements = new ElementListReader(problems);
    List<InputElement> inputs =
        given.getInputSpecList() == null
            ? List.of()
            : elements.inputs(given.getInputSpecList().getTestElement());
    List<OutputElement> outputs =
        given.getOutputSpecList() == null
            ? List.of()
            : elements.outputs(given.getOutputSpecList().getTestElement());
    ConditionReader conditions = new ConditionReader(problems);
    Target target = new TargetReader(problems).read(given, model.target().interfaceName(), name);
    TestModel called =
        new TestModel(
            name,
            "",
            target,
            model.definitions(),
            Map.of(),
            conditions.read(
                ConditionReader.PRE_CONDITION,
                given.getPreConditionSpecList() == null
                    ? List.of()
                    : given.getPreConditionSpecList().getPreCondition()),
            inputs,
            outputs,
            conditions.read(
                ConditionReader.POST_CONDITION,
                given.getPostConditionSpecList() == null
                    ? List.of()
                    : given.getPostConditionSpecList().getPostCondition()),
            List.of(),
            List.of(),
            model.invalidValues(),
            inputs.isEmpty() ? new Strength(1) : model.strength(),
            List.of(),
            List.of(),
            TestModel.UNBOUNDED,
            null,
            null,
            surroundings,
            problems.file());
    Condition guard = guard(given.getGuard(), where + "/guard");
    Condition forbidden = forbidden(given.getForbidden(), where + "/forbidden");
    if (forbidden != null && guard == null) {
      problems.error(
          forbidden.line(),
          where + "/forbidden",
          "has no effect without a guard, which says where the call is forbidden; add a guard");
    }
    boolean overlap = flag(given.getOverlap(), false, where + "/overlap", line);
    return checked(name, where, line)
        ? Optional.of(
            new SequenceCall(
                name, guard, updates(given.getUpdates(), where), forbidden, overlap, called, line))
        : Optional.empty();
  }

  private Optional<SequenceEvent> event(SequenceEventType given) {
    int line = XmlDocuments.line(given);
    String name = text(given.getName());
    String where = "event " + name;
    String set = text(given.getSet());
    if (set.isEmpty() || given.getTo() == null) {
      problems.error(
          line, where, "needs set, a parameter of the world or a fault, and to, its new value");
    }
    Optional<Value> to =
        problems.attempt(
            line,
            where + "/to",
            () -> Value.parse(text(given.getTo()), new DataType.Scalar(ScalarType.DOUBLE)));
    Condition guard = guard(given.getGuard(), where + "/guard");
    List<StateUpdate> updates = updates(given.getUpdates(), where);
    return checked(name, where, line)
        ? to.map(value -> new SequenceEvent(name, set, value, guard, updates, line))
        : Optional.empty();
  }

  private boolean checked(String name, String where, int line) {
    if (ConditionReader.NAME.matcher(name).matches()) {
      return true;
    }
    problems.error(line, where, "needs a name of letters, digits and '_', not '" + name + "'");
    return false;
  }

  private @Nullable Condition guard(@Nullable ConditionType given, String where) {
    if (given == null) {
      return null;
    }
    int line = XmlDocuments.line(given);
    if (!text(given.getName()).isEmpty()) {
      problems.error(line, where, "a name has no effect here, only on a post_condition");
    }
    return formula(given.getValue(), where, line);
  }

  private @Nullable Condition forbidden(@Nullable ExpectedFormulaType given, String where) {
    if (given == null) {
      return null;
    }
    int line = XmlDocuments.line(given);
    if (given.getOrError() != null) {
      problems.error(line, where, "or_error has no effect here; write an expression with !error");
    }
    return formula(given.getValue(), where, line);
  }

  private @Nullable Condition formula(@Nullable String given, String where, int line) {
    if (text(given).isEmpty()) {
      problems.error(line, where, "has no expression");
      return null;
    }
    return new Condition(text(given), line);
  }

  private List<StateUpdate> updates(List<StateUpdateType> given, String where) {
    List<StateUpdate> updates = new ArrayList<>();
    Set<String> seen = new HashSet<>();
    for (StateUpdateType update : given) {
      int line = XmlDocuments.line(update);
      String state = text(update.getState());
      Set<String> known = new HashSet<>(surroundings.keySet());
      known.remove(SequenceSpec.STEP);
      if (!known.contains(state)) {
        problems.error(
            line,
            where + "/update",
            "there is no state '" + state + "'" + NearestName.hint(state, known));
      } else if (!seen.add(state)) {
        problems.error(line, where + "/update", "another update changes " + state);
      } else if (text(update.getValue()).isEmpty()) {
        problems.error(line, where + "/update", "has no expression");
      } else {
        updates.add(new StateUpdate(state, text(update.getValue()), line));
      }
    }
    return updates;
  }

  private void verifyNames(
      List<StateVariable> states, List<SequenceCall> calls, List<SequenceEvent> events) {
    Set<String> steps = new HashSet<>();
    calls.forEach(c -> distinct(steps, c.name(), "call " + c.name(), c.line()));
    events.forEach(e -> distinct(steps, e.name(), "event " + e.name(), e.line()));
    Set<String> names = new HashSet<>();
    Set<String> reserved =
        Set.of(
            SequenceSpec.STEP, SequenceSpec.STEPS, "valid", "error", "calls", "messages", "actual");
    Set<String> inputs = new HashSet<>(model.inputs().stream().map(InputElement::name).toList());
    calls.forEach(c -> c.model().inputs().forEach(i -> inputs.add(i.name())));
    Set<String> roots = inputs.stream().map(MemberPath::root).collect(Collectors.toSet());
    for (StateVariable state : states) {
      String where = "state " + state.name();
      if (checked(state.name(), where, state.line())) {
        distinct(names, state.name(), where, state.line());
      }
      if (roots.contains(state.name())) {
        problems.error(state.line(), where, "an input has this name; rename the state");
      } else if (reserved.contains(state.name())
          || model.definitions().stream().anyMatch(d -> d.name().equals(state.name()))) {
        problems.error(
            state.line(), where, "expressions use this name for something else; rename the state");
      }
    }
  }

  private void distinct(Set<String> names, String name, String where, int line) {
    if (!names.add(name)) {
      problems.error(line, where, "another one has this name; give it a name of its own");
    }
  }

  /** A number from 1; 0 if it is invalid, which is reported. */
  private int number(@Nullable String given, String name, int most, int line) {
    return problems
        .attempt(
            line,
            "sequence_spec/" + name,
            () -> {
              int number =
                  Settings.whole(
                      Settings.required(given, "is missing; write a number from 1 to " + most), 1);
              if (number > most) {
                throw new IllegalArgumentException("must be at most " + most + ", not " + number);
              }
              return number;
            })
        .orElse(0);
  }

  private boolean flag(@Nullable String given, boolean otherwise, String where, int line) {
    return problems
        .attempt(line, where, () -> Settings.parseBoolean(given, otherwise))
        .orElse(otherwise);
  }
}
