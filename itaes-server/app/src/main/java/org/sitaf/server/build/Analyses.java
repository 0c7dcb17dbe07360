package org.sitaf.server.build;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.quota.Quotas;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** Requests and finds the analyses of builds. */
@Service
public class Analyses {
  private final BuildRepository builds;
  private final Builds requests;
  private final AnalysisQueue queue;
  private final AnalysisReports reports;
  private final StoredFiles contents;
  private final Quotas quotas;
  private final TransactionTemplate transaction;

  Analyses(
      BuildRepository builds,
      Builds requests,
      AnalysisQueue queue,
      AnalysisReports reports,
      StoredFiles contents,
      Quotas quotas,
      TransactionTemplate transaction) {
    this.builds = builds;
    this.requests = requests;
    this.queue = queue;
    this.reports = reports;
    this.contents = contents;
    this.quotas = quotas;
    this.transaction = transaction;
  }

  /** Shows an analysis. */
  @FunctionalInterface
  public interface View<T> {
    /** Shows an analysis with its report as JSON; null if it has none. */
    T of(Build analysis, byte @Nullable [] report);
  }

  /** Chooses a case that the suite does not contain. */
  @FunctionalInterface
  public interface FurtherCase {
    /**
     * The suite with this case alone; empty if the case may not be executed.
     *
     * @param no the number that follows those of the suite
     */
    Optional<TestSuite> of(TestModel model, TestSuite suite, int no);
  }

  /**
   * Requests an explanation or a score of a build that has a result.
   *
   * @throws RequestException if the build cannot be analysed, or the same analysis has not ended
   */
  public void request(String buildId, BuildKind kind) {
    request(buildId, analysed -> queue.queue(analysed, kind));
  }

  /**
   * Requests further runs of the cases of a build that has a result.
   *
   * @throws RequestException if the cases cannot be repeated, or a repetition has not ended
   */
  public void repeat(String buildId, int runs) {
    request(buildId, analysed -> queue.repeat(analysed, runs));
  }

  private void request(String buildId, UnaryOperator<Build> queued) {
    transaction.executeWithoutResult(
        status -> {
          Build analysed =
              builds
                  .findForUpdate(buildId)
                  .orElseThrow(() -> RequestException.notFound("build", buildId));
          quotas.ownBuild(queued.apply(analysed).id());
        });
  }

  /**
   * The latest analysis of a kind; empty if none was requested.
   *
   * @throws RequestException if there is no such build
   */
  public <T> Optional<T> latest(String buildId, BuildKind kind, View<T> view) {
    return Optional.ofNullable(
        transaction.execute(
            status -> {
              if (builds.findById(buildId).isEmpty()) {
                throw RequestException.notFound("build", buildId);
              }
              return queue
                  .latest(buildId, kind)
                  .map(analysis -> view.of(analysis, reports.find(analysis.id()).orElse(null)))
                  .orElse(null);
            }));
  }

  /** The test application of a build. */
  public TestApplication application(String buildId) {
    return TestApplication.read(contents.load(requests.inspect(buildId, Build::files)));
  }

  /**
   * Requests a build of a case that the suite does not contain, with the files of an earlier build.
   *
   * @return its id
   */
  public String run(String buildId, FurtherCase chosen) {
    TestApplication application = application(buildId);
    TestSuite suite = application.suite();
    int next = suite.cases().stream().mapToInt(TestCase::no).max().orElse(0) + 1;
    TestSuite only =
        chosen
            .of(application.model(), suite, next)
            .orElseThrow(() -> RequestException.conflict("The case may not be executed."));
    return requests.requestFurther(buildId, Shards.withCases(application, only.cases()));
  }
}
