package org.sitaf.core.explain;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.explain.Explanation.Boundary;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestSpec;
import org.sitaf.core.model.Value;
import org.sitaf.core.verdict.CaseResult;

/**
 * Brackets the boundary of a cause: moves one numeric parameter of its simplest case from the
 * nearest value that passes to the failing one, by bisection.
 */
final class BoundarySearch {
  /** Further cases that look for a value that passes. */
  private static final int MAX_PROBES = 4;

  private final SuiteValues values;
  private final History history;
  private final FurtherCases further;

  /** The boundaries that were found, by the parameter and the other values of the cause. */
  private final Map<List<Object>, List<Bracket>> known = new HashMap<>();

  private record Bracket(long passes, long fails, Boundary boundary) {}

  BoundarySearch(SuiteValues values, History history, FurtherCases further) {
    this.values = values;
    this.history = history;
    this.further = further;
  }

  /** The boundary of a cause; empty if it has no numeric parameter with a range. */
  Optional<Boundary> of(Tuple cause, List<Value> simplest) throws InterruptedException {
    int[] tuple = cause.values();
    for (boolean real : new boolean[] {true, false}) {
      for (int p = 0; p < tuple.length; p++) {
        if (tuple[p] != Tuple.ANY
            && hasRange(values.input(p))
            && values.levelsOf(p).get(tuple[p]) instanceof Value.Real == real
            && SuiteValues.isFinite(values.levelsOf(p).get(tuple[p]))
            && values.isValid(p, values.levelsOf(p).get(tuple[p]))) {
          Optional<Boundary> found = of(cause, p, simplest);
          if (found.isPresent()) {
            return found;
          }
        }
      }
    }
    return Optional.empty();
  }

  private static boolean hasRange(InputElement input) {
    return (input.kind() == InputKind.TDI || input.kind() == InputKind.TDSD)
        && SuiteValues.isNumber(input)
        && input.specs().stream()
            .anyMatch(
                s ->
                    s instanceof TestSpec.BoundaryValues
                        || s instanceof TestSpec.EquivalencePartitioning
                        || s instanceof TestSpec.RandomNumbers);
  }

  private Optional<Boundary> of(Tuple cause, int p, List<Value> simplest)
      throws InterruptedException {
    NumberLine line = new NumberLine(values.input(p));
    int[] tuple = cause.values();
    int level = tuple[p];
    long fails = line.position(values.levelsOf(p).get(level));
    tuple[p] = Tuple.ANY;
    List<Object> key = List.of(p, new Tuple(tuple));
    Optional<Integer> passing = passing(cause, p, simplest);
    if (passing.isEmpty()) {
      return Optional.empty();
    }
    long passes = line.position(values.levelsOf(p).get(passing.get()));
    for (Bracket bracket : known.getOrDefault(key, List.of())) {
      if (isBetween(bracket.passes(), passes, fails) && isBetween(bracket.fails(), passes, fails)) {
        return Optional.of(bracket.boundary());
      }
    }
    long step = Long.signum(Long.compare(passes, fails));
    if (passes != fails + step) {
      // Often only a single value fails.
      Boolean neighbour = fails(simplest, p, line.value(fails + step));
      if (neighbour == null) {
        return Optional.empty();
      }
      if (neighbour) {
        fails += step;
      } else {
        passes = fails + step;
      }
    }
    while (passes != fails + step && !further.isExhausted()) {
      long middle = NumberLine.middle(passes, fails);
      if (middle == passes || middle == fails) {
        break;
      }
      Boolean failed = fails(simplest, p, line.value(middle));
      if (failed == null) {
        return Optional.empty();
      }
      if (failed) {
        fails = middle;
      } else {
        passes = middle;
      }
    }
    Boundary boundary =
        new Boundary(
            values.input(p).name(), line.value(passes).literal(), line.value(fails).literal());
    known.computeIfAbsent(key, k -> new ArrayList<>()).add(new Bracket(passes, fails, boundary));
    return Optional.of(boundary);
  }

  private static boolean isBetween(long position, long a, long b) {
    return Math.min(a, b) <= position && position <= Math.max(a, b);
  }

  /** The nearest valid level with which a case of the other values passes. */
  private Optional<Integer> passing(Tuple cause, int p, List<Value> simplest)
      throws InterruptedException {
    List<Value> levels = values.levelsOf(p);
    int level = cause.values()[p];
    List<Integer> nearest = new ArrayList<>();
    for (int distance = 1; distance < levels.size(); distance++) {
      for (int other : new int[] {level - distance, level + distance}) {
        if (other >= 0
            && other < levels.size()
            && SuiteValues.isFinite(levels.get(other))
            && values.isValid(p, levels.get(other))) {
          nearest.add(other);
        }
      }
    }
    for (int other : nearest) {
      if (history.isRefuted(with(cause, p, other))) {
        return Optional.of(other);
      }
    }
    int probes = 0;
    for (int other : nearest) {
      if (probes++ < MAX_PROBES && !further.isExhausted()) {
        Boolean failed = fails(simplest, p, levels.get(other));
        if (failed != null && !failed) {
          return Optional.of(other);
        }
      }
    }
    return Optional.empty();
  }

  private static Tuple with(Tuple cause, int p, int level) {
    int[] changed = cause.values();
    changed[p] = level;
    return new Tuple(changed);
  }

  /** Whether the simplest case fails with another value; null if it may not be executed. */
  private @Nullable Boolean fails(List<Value> simplest, int p, Value value)
      throws InterruptedException {
    List<Value> row = new ArrayList<>(simplest);
    row.set(p, value);
    Optional<CaseResult> result = further.execute(row);
    return result.isEmpty() ? null : FurtherCases.outcome(result.get()).failed();
  }
}
