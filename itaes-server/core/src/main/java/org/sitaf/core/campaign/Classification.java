package org.sitaf.core.campaign;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.Tolerance;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;

/** Compares a case with faults with the same case without. */
public final class Classification {
  private final List<OutputElement> outputs;
  private final List<String> commands;

  /**
   * A classification.
   *
   * @param outputs of the model, with their tolerances
   */
  public Classification(List<OutputElement> outputs, WorldDescription world) {
    this.outputs = List.copyOf(outputs);
    this.commands =
        WorldSignals.of(world).stream().filter(name -> name.endsWith(".command")).toList();
  }

  /** A behaviour and its reason. */
  public record Classified(Behaviour behaviour, String reason) {}

  /** What the component does; empty if the case was not executed. */
  public Optional<Classified> of(Observed healthy, Observed faulty) {
    CaseResult result = faulty.result();
    if (result.verdict() == Verdict.DONT) {
      return Optional.empty();
    }
    if (result.verdict() == Verdict.ERROR) {
      return Optional.of(new Classified(Behaviour.CRASHED, result.message()));
    }
    if (result.verdict() == Verdict.FAIL) {
      return Optional.of(new Classified(Behaviour.BROKEN, result.message()));
    }
    String difference = difference(healthy.result(), result);
    if (difference.isEmpty()) {
      return Optional.of(
          new Classified(
              commandsEqual(healthy, faulty) ? Behaviour.UNCHANGED : Behaviour.RECOVERED, ""));
    }
    return Optional.of(
        new Classified(stopped(faulty) ? Behaviour.STOPPED : Behaviour.BROKEN, difference));
  }

  /** The first output with another value; empty if there is none. */
  private String difference(CaseResult healthy, CaseResult faulty) {
    for (int i = 0; i < Math.min(healthy.actual().size(), faulty.actual().size()); i++) {
      NamedValue before = healthy.actual().get(i);
      NamedValue after = faulty.actual().get(i);
      if (!isSame(before, after)) {
        return (before.output().isEmpty() ? "the output" : before.output())
            + " is "
            + after.literal()
            + ", without faults "
            + before.literal();
      }
    }
    return "";
  }

  private boolean isSame(NamedValue before, NamedValue after) {
    if (before.literal().equals(after.literal())) {
      return true;
    }
    Tolerance tolerance =
        outputs.stream()
            .filter(
                o ->
                    o.name().equals(before.output())
                        || (before.output().isEmpty() && outputs.size() == 1))
            .map(OutputElement::tolerance)
            .findFirst()
            .orElse(Tolerance.EXACT);
    try {
      double expected = Double.parseDouble(before.literal());
      double actual = Double.parseDouble(after.literal());
      // Both runs may be off by the tolerance.
      return Math.abs(actual - expected)
          <= 2 * (tolerance.absolute() + tolerance.relative() * Math.abs(expected));
    } catch (NumberFormatException e) {
      return false;
    }
  }

  private boolean commandsEqual(Observed healthy, Observed faulty) {
    return commands.stream()
        .allMatch(
            name ->
                Arrays.equals(
                    healthy.signal(name).orElse(new double[0]),
                    faulty.signal(name).orElse(new double[0])));
  }

  /** Whether the component commands its actuators, and none of them to move at the end. */
  private boolean stopped(Observed faulty) {
    boolean isCommanding = false;
    for (String name : commands) {
      Optional<double[]> signal = faulty.signal(name);
      if (signal.isEmpty()) {
        continue;
      }
      isCommanding = true;
      boolean isPosition = name.endsWith(".position.command") || name.endsWith(".width.command");
      double[] values = signal.get();
      double last = values[values.length - 1];
      if (isPosition ? last != values[values.length * 3 / 4] : last != 0) {
        return false;
      }
    }
    return isCommanding;
  }
}
