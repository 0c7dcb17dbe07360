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
 * Combines the models that standard input names, one a line: strength, effort, levels, forbidden
 * tuples as {@code parameter=value&...}, separated by tabs. Answers each with the rows and seconds
 * of the first complete array and of the smallest, the seconds in all, and what the check found.
 */
public final class Ours {
  private Ours() {}

  /** Reads models and answers them in turn; a process that has answered one is warm. */
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
    double[] first = new double[2];
    double[] best = new double[2];
    CoveringArray array =
        new TestDataCombinator()
            .combine(
                problem,
                Effort.valueOf(line[1]),
                1,
                (rows, share) -> {
                  double now = (System.nanoTime() - began) / 1e9;
                  if (first[0] == 0) {
                    first[0] = rows;
                    first[1] = now;
                  }
                  if (rows != best[0]) {
                    best[0] = rows;
                    best[1] = now;
                  }
                });
    double whole = (System.nanoTime() - began) / 1e9;
    int findings = CoveringCheck.findings(problem, array).size();
    return "%.0f\t%.3f\t%d\t%.3f\t%.3f\t%d"
        .formatted(first[0], first[1], array.size(), best[1], whole, findings);
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
