import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Scanner;
import org.sitaf.core.combine.CombinationProblem;
import org.sitaf.core.combine.Constraint;
import org.sitaf.core.combine.CoveringArray;
import org.sitaf.core.combine.CoveringCheck;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.combine.TestDataCombinator;

/**
 * Runs SITAF's combinator on models from standard input. Each line has the strength, the effort, the
 * levels, and the forbidden tuples as {@code parameter=value&...}, separated by tabs. Prints for each
 * the number of rows, the total seconds, the number of findings of the check, and all improvements
 * as {@code rows@seconds}.
 */
public final class Ours {
  private Ours() {}

  /** Processes models in order; the JVM is warm after the first one. */
  public static void main(String[] args) {
    try (Scanner lines = new Scanner(System.in)) {
      while (lines.hasNextLine()) {
        System.out.println(answer(lines.nextLine().split("\t", -1)));
        System.out.flush();
      }
    }
  }

  private static String answer(String[] line) {
    int[] levels = Arrays.stream(line[2].split(",")).mapToInt(Integer::parseInt).toArray();
    CombinationProblem problem =
        CombinationProblem.tWay(Integer.parseInt(line[0]), levels)
            .withConstraints(constraints(line[3]));
    long began = System.nanoTime();
    List<String> improvements = new ArrayList<>();
    int[] smallest = {Integer.MAX_VALUE};
    CoveringArray array =
        new TestDataCombinator()
            .combine(
                problem,
                Effort.valueOf(line[1]),
                1,
                (rows, share) -> {
                  if (rows < smallest[0]) {
                    smallest[0] = rows;
                    improvements.add("%d@%.3f".formatted(rows, seconds(began)));
                  }
                });
    double whole = seconds(began);
    if (array.size() < smallest[0]) {
      improvements.add("%d@%.3f".formatted(array.size(), whole));
    }
    int findings = CoveringCheck.findings(problem, array).size();
    return "%d\t%.3f\t%d\t%s"
        .formatted(array.size(), whole, findings, String.join(" ", improvements));
  }

  private static double seconds(long since) {
    return (System.nanoTime() - since) / 1e9;
  }

  private static List<Constraint> constraints(String forbidden) {
    List<Constraint> constraints = new ArrayList<>();
    for (String tuple : forbidden.isEmpty() ? new String[0] : forbidden.split(";")) {
      String[] cells = tuple.split("&");
      int[] parameters = new int[cells.length];
      int[] values = new int[cells.length];
      for (int i = 0; i < cells.length; i++) {
        String[] cell = cells[i].split("=");
        parameters[i] = Integer.parseInt(cell[0]);
        values[i] = Integer.parseInt(cell[1]);
      }
      constraints.add(Constraint.forbid(parameters, values));
    }
    return constraints;
  }
}
