import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/** Prints measured figures with their targets, and keeps those that fall short. */
final class Rows {
  private final List<String> shortOf = new ArrayList<>();

  /** Prints a figure without a target. */
  void print(String what, double value, String unit) {
    System.out.printf(Locale.ROOT, "%-58s %10.2f %s%n", what, value, unit);
  }

  /**
   * Prints a figure.
   *
   * @param target NaN for none
   * @param atLeast whether the target is a minimum
   * @param ratio the figure in units of an alternative that was measured in the same run
   */
  void row(
      String what, double value, String unit, double target, boolean atLeast, double ratio, String alternative) {
    boolean hasTarget = !Double.isNaN(target);
    boolean held = !hasTarget || (atLeast ? value >= target : value < target);
    if (!held) {
      fail(what);
    }
    System.out.printf(
        Locale.ROOT,
        "%-58s %10s %-8s %-16s %-6s%.1f times %s%n",
        what,
        String.format(Locale.ROOT, value < 10 ? "%.2f" : "%.0f", value),
        unit,
        hasTarget ? (atLeast ? "at least " : "under ") + (target < 10 ? target : (long) target) : "",
        hasTarget ? (held ? "held" : "SHORT") : "",
        ratio,
        alternative);
  }

  /** Adds a problem to the last line. */
  void fail(String what) {
    shortOf.add(what);
  }

  /** Prints the last line; whether all targets were held. */
  boolean end(String program) {
    System.out.println(
        program + ": " + (shortOf.isEmpty() ? "held" : "short: " + String.join(", ", shortOf)));
    return shortOf.isEmpty();
  }
}
