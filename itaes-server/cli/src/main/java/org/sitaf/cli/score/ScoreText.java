package org.sitaf.cli.score;

import java.io.PrintWriter;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.score.SpecificationScore;
import org.sitaf.core.score.SpecificationScore.Survivor;
import org.sitaf.core.score.mutation.MutationScore;

/** Prints a score, and the faults that are not noticed. */
final class ScoreText {
  private static final int MAX_SURVIVORS = 20;
  private static final double PERCENT = 100;

  private ScoreText() {}

  /**
   * Prints the score of a model.
   *
   * @param all whether all survivors are printed
   */
  static void print(String model, SpecificationScore score, boolean all, PrintWriter out) {
    out.printf(
        Locale.ROOT,
        "%s: score %.1f %%: %d of %d faults with an effect are noticed; %d change no recorded"
            + " value%n",
        model,
        PERCENT * score.share(),
        score.noticed(),
        score.injected() - score.equivalent(),
        score.equivalent());
    score.warnings().forEach(warning -> out.println("  warning: " + Printable.line(warning)));
    score
        .byOutput()
        .forEach(
            (output, count) ->
                out.printf(
                    Locale.ROOT,
                    "  %s: %d of %d noticed%n",
                    Printable.line(output),
                    count.noticed(),
                    count.changed()));
    print(score.survivors(), all, out);
  }

  /**
   * Prints the score of a model by mutations of the sources.
   *
   * @param all whether all survivors, and the mutations without an effect, are printed
   */
  static void print(String model, MutationScore score, boolean all, PrintWriter out) {
    out.printf(
        Locale.ROOT,
        "%s: mutations of the sources %.1f %%: %d of %d with an effect are noticed; %d change no"
            + " recorded value%n",
        model,
        PERCENT * score.share(),
        score.noticed(),
        score.made() - score.unchanged().size(),
        score.unchanged().size());
    print(score.survivors(), all, out);
    if (all && !score.unchanged().isEmpty()) {
      out.println("without an effect in these cases:");
      score
          .unchanged()
          .forEach(m -> out.println("  " + Printable.line(m.where() + ": " + m.change())));
      out.flush();
    }
  }

  private static void print(List<Survivor> survivors, boolean all, PrintWriter out) {
    int left = all ? Integer.MAX_VALUE : MAX_SURVIVORS;
    if (!survivors.isEmpty()) {
      out.println("not noticed:");
    }
    for (Map.Entry<String, List<String>> each : bySuggestion(survivors).entrySet()) {
      if (left <= 0) {
        break;
      }
      for (String fault : each.getValue().subList(0, Math.min(left, each.getValue().size()))) {
        out.println("  " + Printable.line(fault));
      }
      left -= each.getValue().size();
      out.println("    " + Printable.line(each.getKey()));
    }
    if (left < 0 || !all && survivors.size() > MAX_SURVIVORS) {
      out.println("... " + survivors.size() + " are not noticed; --all prints all of them");
    }
    out.flush();
  }

  /** Faults with the same suggestion are printed together. */
  private static Map<String, List<String>> bySuggestion(List<Survivor> survivors) {
    Map<String, List<String>> groups = new LinkedHashMap<>();
    for (Survivor survivor : survivors) {
      groups.computeIfAbsent(survivor.suggestion(), s -> new ArrayList<>()).add(survivor.fault());
    }
    return groups;
  }
}
