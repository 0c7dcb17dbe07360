package org.sitaf.agent.analysis;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.regex.Pattern;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.score.mutation.Mutation;
import org.sitaf.core.score.mutation.MutationJudge;
import org.sitaf.core.score.mutation.MutationScore;
import org.sitaf.core.score.mutation.Mutations;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/** Scores one model by mutations of the component's sources. Each mutation is a build. */
public final class MutatedModel {
  /** Mutations are chosen in an order that depends on nothing else. */
  private static final long SEED = 1;

  private static final Pattern SOURCE =
      Pattern.compile(".*\\.(?:java|py|c|cc|cpp|cxx|h|hh|hpp|hxx|ipp)");

  private final Activity activity;
  private final TestSuite suite;
  private final Runner runner;

  /** Executes the cases of the suite. */
  @FunctionalInterface
  public interface Runner {
    /**
     * Builds an activity and executes all cases.
     *
     * @param ends receives each result, in any thread; true cancels the build
     */
    BuildOutcome run(Activity activity, Predicate<CaseResult> ends) throws InterruptedException;
  }

  /** A model without repeated calls, which {@code runner} executes. */
  public MutatedModel(Activity activity, TestSuite suite, Runner runner) {
    this.activity = activity;
    this.suite = suite;
    this.runner = runner;
  }

  /** Number of mutations of an activity's sources, before any is compiled; 0 without sources. */
  public static int count(Activity activity) {
    return all(activity).size();
  }

  /**
   * The score.
   *
   * @param max maximum number of mutations that are executed; the others are left out at random
   * @param atMost after this time, no further mutation is begun
   * @param progress gets the number of mutations that were executed
   * @throws InvalidInputException if the component itself cannot be executed
   */
  public MutationScore score(int max, Duration atMost, Consumer<Integer> progress)
      throws InterruptedException {
    long end = System.nanoTime() + atMost.toNanos();
    List<Mutation> mutations = all(activity);
    if (!(runner.run(activity, c -> false) instanceof BuildOutcome.Completed original)) {
      throw InvalidInputException.of(
          suite.modelName(), "the component cannot be executed without mutations");
    }
    MutationJudge judge = new MutationJudge(original.result());
    Collections.shuffle(mutations, new Random(SEED));
    for (Mutation mutation : mutations) {
      if (judge.score().made() == max || System.nanoTime() - end > 0) {
        break;
      }
      execute(mutation, judge);
      progress.accept(judge.score().made());
    }
    return judge.score();
  }

  private void execute(Mutation mutation, MutationJudge judge) throws InterruptedException {
    String source = activity.files().text(mutation.path()).orElseThrow();
    Activity mutated =
        activity.withSource(
            mutation.path(),
            mutation.applied(source).getBytes(java.nio.charset.StandardCharsets.UTF_8));
    Watch watch = new Watch(judge);
    BuildOutcome outcome = runner.run(mutated, watch);
    if (watch.noticed) {
      judge.addNoticed();
    } else if (outcome instanceof BuildOutcome.Completed completed
        && isExecuted(completed.result())) {
      judge.add(mutation, completed.result());
    } else if (outcome instanceof BuildOutcome.Cancelled cancelled) {
      throw new InterruptedException(cancelled.reason());
    }
    // A mutation that the compiler rejects is none.
  }

  private static boolean isExecuted(TestResult result) {
    return result.summary().dont() < result.summary().total();
  }

  /** Ends the build at the first case that notices the mutation. */
  private static final class Watch implements Predicate<CaseResult> {
    private final MutationJudge judge;
    private volatile boolean noticed;

    Watch(MutationJudge judge) {
      this.judge = judge;
    }

    @Override
    public boolean test(CaseResult result) {
      if (judge.notices(result)) {
        noticed = true;
      }
      return noticed;
    }
  }

  private static List<Mutation> all(Activity activity) {
    Component component = activity.profile().component();
    List<Mutation> all = new ArrayList<>();
    if (component.sources() == null) {
      return all;
    }
    String folder =
        component.sources().endsWith("/") ? component.sources() : component.sources() + "/";
    for (String path : activity.files().paths()) {
      boolean isSource = path.startsWith(folder) && SOURCE.matcher(path).matches();
      if (isSource) {
        String text = activity.files().text(path).orElse("");
        all.addAll(Mutations.of(path, text, component.language() == Language.PYTHON));
      }
    }
    return all;
  }
}
