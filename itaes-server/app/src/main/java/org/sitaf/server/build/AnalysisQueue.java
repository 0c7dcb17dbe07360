package org.sitaf.server.build;

import java.time.Clock;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.sitaf.server.build.request.RealDevices;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.result.Results;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.stereotype.Component;
import org.springframework.transaction.annotation.Propagation;
import org.springframework.transaction.annotation.Transactional;

/** Queues analyses of builds that have a result. */
@Component
class AnalysisQueue {
  /** The file of an assignment with the result that is analysed. */
  private static final String ANALYSED = "analysed-result.xml";

  /** Maximum number of further cases of an explanation. */
  private static final int MAX_EXPLAINING = 500;

  /** Maximum number of further cases of a score. */
  private static final int MAX_SCORING = 1_000;

  private static final int MIN_RUNS = 1;
  private static final int MAX_RUNS = 100;

  private final BuildRepository builds;
  private final Results results;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  AnalysisQueue(
      BuildRepository builds, Results results, ApplicationEventPublisher events, Clock clock) {
    this.builds = builds;
    this.results = results;
    this.events = events;
    this.clock = clock;
  }

  /** Queues the explanation that was requested with a build; its caller has locked the build. */
  @Transactional(propagation = Propagation.MANDATORY)
  public void explainIfRequested(Build build) {
    if (build.explainsFailures() && build.hasFailures()) {
      queue(build, BuildKind.EXPLANATION);
    }
  }

  /**
   * Queues an analysis; the caller has locked the analysed build.
   *
   * @throws RequestException if the build cannot be analysed, or the same analysis has not ended
   */
  @Transactional(propagation = Propagation.MANDATORY)
  public Build queue(Build analysed, BuildKind kind) {
    return queue(analysed, kind, kind == BuildKind.SCORE ? MAX_SCORING : MAX_EXPLAINING);
  }

  /**
   * Queues further runs of the cases of a build; the caller has locked the build.
   *
   * @throws RequestException if the cases cannot be repeated, or a repetition has not ended
   */
  @Transactional(propagation = Propagation.MANDATORY)
  public Build repeat(Build analysed, int runs) {
    if (runs < MIN_RUNS || runs > MAX_RUNS) {
      throw RequestException.malformed(
          "runs: must be " + MIN_RUNS + " to " + MAX_RUNS + ", but is " + runs + ".");
    }
    if (analysed.state() == BuildState.DONE && !analysed.suspicions().isEmpty()) {
      throw RequestException.conflict(
          "The verdicts of build " + analysed.id() + " cannot be trusted.");
    }
    if (analysed.casesTotal() == 0) {
      throw RequestException.conflict("Build " + analysed.id() + " has no cases to repeat.");
    }
    return queue(analysed, BuildKind.REPETITION, runs * analysed.casesTotal());
  }

  private Build queue(Build analysed, BuildKind kind, int maxCases) {
    RealDevices.requireNone(analysed.requirements());
    Optional<Build> latest = latest(analysed.id(), kind);
    if (latest.isPresent() && !latest.get().state().isOver()) {
      throw RequestException.conflict(
          "An analysis of build "
              + analysed.id()
              + " is "
              + latest.get().state()
              + "; cancel it first, or wait until it ends.");
    }
    if (kind == BuildKind.EXPLANATION
        && analysed.state() == BuildState.DONE
        && !analysed.hasFailures()) {
      throw RequestException.conflict(
          analysed.suspicions().isEmpty()
              ? "No case of build " + analysed.id() + " failed."
              : "The verdicts of build " + analysed.id() + " cannot be trusted.");
    }
    Build analysis =
        analysed.addAnalysis(
            UUID.randomUUID().toString(),
            kind,
            maxCases,
            clock.instant().truncatedTo(ChronoUnit.MICROS));
    builds.saveAndFlush(analysis);
    events.publishEvent(BuildEvent.Changed.of(analysis));
    return analysis;
  }

  /** The latest analysis of a kind. */
  public Optional<Build> latest(String analysedId, BuildKind kind) {
    return builds.findFirstByAnalysedIdAndKindOrderByCreatedDescIdDesc(analysedId, kind);
  }

  /** The files that an agent may download for a build. */
  public List<StoredFile> filesOf(Build build) {
    List<StoredFile> files = new ArrayList<>(build.files());
    if (build.kind() == BuildKind.EXPLANATION || build.kind() == BuildKind.REPETITION) {
      String analysed = build.analysedId().orElseThrow();
      files.add(
          new StoredFile(ANALYSED, results.sha256(analysed), results.document(analysed).length));
    }
    return List.copyOf(files);
  }
}
