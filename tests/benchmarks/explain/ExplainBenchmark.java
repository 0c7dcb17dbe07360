import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.explain.Causes;
import org.sitaf.core.explain.Tuple;

/** Explains planted causes, and lets the algorithms of coffee4j explain the same ones. */
public final class ExplainBenchmark {
  private static final int PROBLEMS = 300;
  private static final int BUDGET = 500;

  private final Rows rows = new Rows();

  private static final class Score {
    private int exact;
    private int problems;
    private long executions;

    void add(Planted planted, Set<Tuple> found, int further) {
      problems++;
      executions += further;
      if (found.equals(Set.copyOf(planted.causes()))) {
        exact++;
      }
    }

    double share() {
      return 100.0 * exact / problems;
    }

    double average() {
      return (double) executions / problems;
    }
  }

  /** Takes the number of problems, and the seed. */
  public static void main(String[] arguments) throws Exception {
    int problems = arguments.length > 0 ? Integer.parseInt(arguments[0]) : PROBLEMS;
    long seed = arguments.length > 1 ? Long.parseLong(arguments[1]) : 1;
    System.exit(new ExplainBenchmark().measure(problems, seed) ? 0 : 1);
  }

  private boolean measure(int problems, long seed) throws Exception {
    Score[] ours = {new Score(), new Score(), new Score(), new Score()};
    Map<Rivals, Score[]> rivals = new EnumMap<>(Rivals.class);
    for (Rivals rival : Rivals.values()) {
      rivals.put(rival, new Score[] {new Score(), new Score(), new Score(), new Score()});
    }
    for (int i = 0; i < problems; i++) {
      int count = 1 + i % 3;
      Planted planted = Planted.of(seed * 100_000 + i, count);
      Causes causes = Causes.find(planted.combinations(), planted::execute, BUDGET, 1);
      Set<Tuple> found =
          causes.found().stream().map(Causes.Found::tuple).collect(Collectors.toSet());
      if (Boolean.getBoolean("explain.verbose") && !found.equals(Set.copyOf(planted.causes()))) {
        System.out.println(
            "problem " + i + ": planted " + planted.causes() + ", found " + found
                + ", executions " + causes.executions() + ", levels "
                + java.util.Arrays.toString(planted.levels()) + " forbidden " + planted.forbidden());
      }
      ours[0].add(planted, found, causes.executions());
      ours[count].add(planted, found, causes.executions());
      for (Rivals rival : Rivals.values()) {
        Rivals.Answer answer = rival.explain(planted);
        rivals.get(rival)[0].add(planted, answer.causes(), answer.executions());
        rivals.get(rival)[count].add(planted, answer.causes(), answer.executions());
      }
    }
    Score multiple = new Score();
    for (Score score : List.of(ours[2], ours[3])) {
      multiple.exact += score.exact;
      multiple.problems += score.problems;
    }
    double least =
        rivals.values().stream().mapToDouble(s -> s[0].average()).min().orElseThrow();
    rows.row("single causes explained exactly", ours[1].share(), "%", 95, true, best(rivals, 1, ours[1]), "the best rival");
    rows.row("several causes explained exactly", multiple.share(), "%", 85, true, best(rivals, 2, multiple), "the best rival for two");
    rows.row("further executions on average", ours[0].average(), "", least, false, ours[0].average() / least, "the rival with the fewest");
    for (int count = 1; count <= 3; count++) {
      System.out.printf("%d cause(s): ours %.0f %% exact, %.1f executions%n", count, ours[count].share(), ours[count].average());
      for (Rivals rival : Rivals.values()) {
        Score score = rivals.get(rival)[count];
        System.out.printf("  %-26s %.0f %% exact, %.1f executions%n", rival, score.share(), score.average());
      }
    }
    return rows.end("explain");
  }

  private static double best(Map<Rivals, Score[]> rivals, int count, Score ours) {
    double best = rivals.values().stream().mapToDouble(s -> s[count].share()).max().orElseThrow();
    return ours.share() / Math.max(0.1, best);
  }
}
