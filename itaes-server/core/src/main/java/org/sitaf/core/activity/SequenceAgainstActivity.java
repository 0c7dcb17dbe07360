package org.sitaf.core.activity;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldDescription.WorldParameter;
import org.sitaf.core.description.fault.DeviceFaults;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceEvent;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.model.sequence.StateVariable;

/** Verifies the calls, events and states of a sequence against the activity. */
final class SequenceAgainstActivity {
  private final TestModel model;
  private final SequenceSpec sequence;
  private final @Nullable WorldDescription world;
  private final Diagnostics diagnostics = new Diagnostics();

  SequenceAgainstActivity(
      TestModel model, SequenceSpec sequence, @Nullable WorldDescription world) {
    this.model = model;
    this.sequence = sequence;
    this.world = world;
  }

  /**
   * All problems.
   *
   * @param ofCall the problems of the test model of a call
   */
  List<Diagnostic> verify(Function<TestModel, List<Diagnostic>> ofCall) {
    Set<Diagnostic> seen = new HashSet<>();
    for (SequenceCall call : sequence.calls()) {
      for (Diagnostic problem : ofCall.apply(call.model())) {
        Diagnostic located = problem.orAt(call.line(), "call " + call.name());
        if (seen.add(located)) {
          diagnostics.addAll(List.of(located));
        }
      }
    }
    sequence.events().forEach(this::event);
    sequence.states().forEach(this::state);
    return diagnostics.all();
  }

  private void event(SequenceEvent event) {
    String where = "event " + event.name();
    if (world == null) {
      error(event.line(), where, "changes the world, but activity.yaml has no world");
    } else if (event.isFault()) {
      fault(event, world, where);
    } else {
      Set<String> known =
          world.parameters().stream().map(WorldParameter::name).collect(Collectors.toSet());
      double to = event.to() instanceof Value.Real real ? real.number() : Double.NaN;
      world
          .parameter(event.set())
          .ifPresentOrElse(
              parameter -> {
                if (!parameter.contains(to)) {
                  error(
                      event.line(),
                      where,
                      event.to().literal()
                          + " is outside the range "
                          + parameter.range()
                          + " that "
                          + world.path()
                          + " declares; extend this range or change to");
                }
              },
              () ->
                  error(
                      event.line(),
                      where,
                      "sets '"
                          + event.set()
                          + "', but "
                          + world.path()
                          + " has no such parameter"
                          + NearestName.hint(event.set(), known)
                          + (known.isEmpty() ? "" : " It has " + String.join(", ", known))));
    }
  }

  private void fault(SequenceEvent event, WorldDescription in, String where) {
    FaultName name;
    try {
      name = FaultName.parse(event.set());
    } catch (IllegalArgumentException e) {
      error(event.line(), where, "set " + e.getMessage() + ", not '" + event.set() + "'");
      return;
    }
    double to = event.to() instanceof Value.Real real ? real.number() : Double.NaN;
    DeviceFaults.problem(name, in)
        .or(() -> DeviceFaults.problem(name, to))
        .ifPresent(problem -> error(event.line(), where, problem));
  }

  private void state(StateVariable state) {
    String where = "state " + state.name();
    if (state.type().holdsUnknown()) {
      error(
          state.line(),
          where,
          "no interface of the activity defines the type "
              + state.realType()
              + "; a state is boolean, a number, string, a list such as string[], or an enumeration or"
              + " struct that a method uses");
    } else if (state.type() instanceof DataType.Enumeration enumeration
        && !enumeration.literals().contains(state.initial().literal())) {
      error(
          state.line(),
          where,
          "'"
              + state.initial().literal()
              + "' is not a literal of "
              + enumeration.name()
              + "; known literals: "
              + enumeration.literals());
    }
  }

  private void error(int line, String where, String message) {
    diagnostics.error(model.source(), line, where, message);
  }
}
