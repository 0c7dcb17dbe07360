import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.Progress;
import org.sitaf.core.combine.TestDataCombinator;
import org.sitaf.core.explain.Combinations;
import org.sitaf.core.explain.Outcome;
import org.sitaf.core.explain.Tuple;

/**
 * A suite with planted causes of failures.
 *
 * @param forbidden tuples that no row may contain
 * @param causes the first in a row decides its message, so it masks the others
 * @param rows of the suite
 */
record Planted(int[] levels, List<Tuple> forbidden, List<Tuple> causes, List<int[]> rows, boolean messages) {
  private static final int SAMPLES = 400;

  /** A planted problem with this number of causes, of 1 to 3 parameters of 6 to 15. */
  static Planted of(long seed, int count) {
    Random random = new Random(seed);
    while (true) {
      int[] levels = new int[6 + random.nextInt(10)];
      for (int i = 0; i < levels.length; i++) {
        levels[i] = 2 + random.nextInt(6);
      }
      List<Tuple> forbidden = new ArrayList<>();
      for (int i = random.nextBoolean() ? 0 : 1 + random.nextInt(3); i > 0; i--) {
        forbidden.add(tuple(levels, 2, null, random));
      }
      List<Tuple> causes = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        // Half of the further causes overlap with the one before.
        Tuple shared = i > 0 && random.nextBoolean() ? causes.get(i - 1) : null;
        causes.add(tuple(levels, 1 + random.nextInt(3), shared, random));
      }
      List<int[]> rows = rows(levels, forbidden, seed);
      Planted planted = new Planted(levels, forbidden, causes, rows, random.nextBoolean());
      if (planted.isFair(random)) {
        return planted;
      }
    }
  }

  private static Tuple tuple(int[] levels, int size, Tuple shared, Random random) {
    int[] values = new int[levels.length];
    Arrays.fill(values, Tuple.ANY);
    int left = size;
    if (shared != null && size > 1) {
      int[] other = shared.values();
      for (int i = 0; i < other.length && left == size; i++) {
        if (other[i] != Tuple.ANY) {
          values[i] = other[i];
          left--;
        }
      }
    }
    while (left > 0) {
      int i = random.nextInt(levels.length);
      if (values[i] == Tuple.ANY) {
        values[i] = random.nextInt(levels[i]);
        left--;
      }
    }
    return new Tuple(values);
  }

  private static List<int[]> rows(int[] levels, List<Tuple> forbidden, long seed) {
    List<Constraint> constraints =
        forbidden.stream()
            .map(
                t -> {
                  int[] parameters =
                      java.util.stream.IntStream.range(0, levels.length)
                          .filter(i -> t.values()[i] != Tuple.ANY)
                          .toArray();
                  return Constraint.forbid(
                      parameters, Arrays.stream(parameters).map(i -> t.values()[i]).toArray());
                })
            .toList();
    return List.of(
        new TestDataCombinator()
            .combine(
                CombinationProblem.tWay(2, levels).withConstraints(constraints),
                Effort.FAST,
                seed,
                Progress.NONE)
            .rows());
  }

  boolean allowed(int[] row) {
    return forbidden.stream().noneMatch(t -> t.isIn(row));
  }

  Outcome execute(int[] row) {
    for (int i = 0; i < causes.size(); i++) {
      if (causes.get(i).isIn(row)) {
        return new Outcome(true, messages ? "ERROR " + i : "FAIL");
      }
    }
    return Outcome.PASSED;
  }

  Combinations combinations() {
    return new Combinations(
        levels,
        rows.stream().map(r -> new Combinations.Row(r, execute(r))).toList(),
        this::allowed,
        2);
  }

  /** Whether each cause is minimal, occurs in the suite, and is not all of it. */
  private boolean isFair(Random random) {
    for (Tuple cause : causes) {
      int[] values = cause.values();
      if (rows.stream().noneMatch(cause::isIn) || !isReachable(values, cause, random)) {
        return false;
      }
      for (int i = 0; i < values.length; i++) {
        if (values[i] != Tuple.ANY) {
          int[] part = values.clone();
          part[i] = Tuple.ANY;
          if (!isReachable(part, null, random)) {
            return false;
          }
        }
      }
    }
    return true;
  }

  /** Whether an allowed row with these values has no cause except the given one. */
  private boolean isReachable(int[] values, Tuple except, Random random) {
    for (int n = 0; n < SAMPLES; n++) {
      int[] row = new int[levels.length];
      for (int i = 0; i < row.length; i++) {
        row[i] = values[i] == Tuple.ANY ? random.nextInt(levels[i]) : values[i];
      }
      if (allowed(row) && causes.stream().allMatch(c -> c.equals(except) || !c.isIn(row))) {
        return true;
      }
    }
    return false;
  }
}
