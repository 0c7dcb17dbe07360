package org.sitaf.server.build;

import jakarta.persistence.CollectionTable;
import jakarta.persistence.Column;
import jakarta.persistence.ElementCollection;
import jakarta.persistence.Embedded;
import jakarta.persistence.Entity;
import jakarta.persistence.EnumType;
import jakarta.persistence.Enumerated;
import jakarta.persistence.Id;
import jakarta.persistence.JoinColumn;
import jakarta.persistence.OrderColumn;
import jakarta.persistence.Version;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.BuildSource;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.build.request.Requirement;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.build.request.Reservation;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.suite.SuiteOrigin;

/**
 * A request to execute a suite, and its outcome. The test application is stored with the request.
 */
@Entity
public class Build {
  private static final int MAX_SUSPICIONS = 8000;

  @Id private String id;

  @Column(name = "activity_id")
  private String activityId;

  private String activityName;
  private String suiteId;
  private String model;
  private String language;

  @Enumerated(EnumType.STRING)
  private BuildState state;

  private int attempt;
  private int failures;
  private @Nullable String agent;
  private Instant created;
  private @Nullable Instant started;
  private @Nullable Instant finished;

  /** Null for a new entity; this is how the persistence provider recognizes one. */
  @Version private @Nullable Long version;

  private int priority;
  private int maxAttempts;
  private @Nullable Instant notBefore;
  private String requirements;
  private @Nullable String parentId;
  private @Nullable String commitId;
  private @Nullable String buildLabels;
  private int shard;
  private int shards;

  @Enumerated(EnumType.STRING)
  private BuildKind kind = BuildKind.TEST;

  private @Nullable String analysedId;
  private boolean explainFailures;

  @Enumerated(EnumType.STRING)
  private RecordedCases recordedCases;

  private @Nullable String caseNumbers;
  @Embedded private CaseProgress cases;

  @Enumerated(EnumType.STRING)
  private BuildFailure.@Nullable Category failureCategory;

  private @Nullable String failureMessage;
  @Embedded private @Nullable CaseCounts counts;
  private @Nullable String suspicions;
  private @Nullable String scheduleId;
  private @Nullable Instant fireTime;

  @ElementCollection
  @CollectionTable(name = "build_file", joinColumns = @JoinColumn(name = "build_id"))
  private Set<StoredFile> files = new HashSet<>();

  @ElementCollection
  @CollectionTable(name = "build_diagnostic", joinColumns = @JoinColumn(name = "build_id"))
  @OrderColumn(name = "position")
  private List<BuildFailure.SourceProblem> problems = new ArrayList<>();

  @ElementCollection
  @CollectionTable(name = "build_transition", joinColumns = @JoinColumn(name = "build_id"))
  @OrderColumn(name = "position")
  private List<Transition> transitions = new ArrayList<>();

  /** For the persistence provider. */
  protected Build() {
    id = "";
    activityId = "";
    activityName = "";
    suiteId = "";
    model = "";
    language = "";
    requirements = "";
    recordedCases = RecordedCases.NONE;
    state = BuildState.QUEUED;
    created = Instant.EPOCH;
    cases = new CaseProgress();
  }

  /**
   * Creates a queued build.
   *
   * @param maxAttempts maximum number of attempts if the infrastructure fails
   * @param reservation null for a build that was not requested by a schedule
   */
  Build(
      String id,
      SuiteOrigin origin,
      FrozenApplication application,
      BuildOptions options,
      int maxAttempts,
      @Nullable Reservation reservation,
      Instant now) {
    this();
    this.id = id;
    this.activityId = origin.activityId();
    this.activityName = origin.activityName();
    this.suiteId = origin.suiteId();
    this.model = origin.model();
    this.priority = options.priority();
    this.maxAttempts = maxAttempts;
    this.created = now;
    freeze(application);
    this.recordedCases = application.recordedCases(options.recordings());
    CaseNumbers numbers = options.cases();
    this.caseNumbers = numbers == null ? null : numbers.merged().toString();
    this.explainFailures = options.explain();
    if (reservation != null) {
      this.scheduleId = reservation.scheduleId();
      this.fireTime = reservation.fireTime();
    }
    move(BuildState.QUEUED, now, reservation == null ? "requested" : "scheduled time reached");
  }

  /** Says which state of the sources it tests. */
  void describe(BuildSource source) {
    commitId = source.commit();
    buildLabels = source.labelText();
  }

  /** Creates a shard: a build that executes some of this build's cases. */
  Build addShard(String shardId, int no, FrozenApplication application, Instant now) {
    Build created = new Build();
    created.id = shardId;
    created.activityId = activityId;
    created.activityName = activityName;
    created.suiteId = suiteId;
    created.model = model;
    created.priority = priority;
    created.maxAttempts = maxAttempts;
    created.created = now;
    created.parentId = id;
    created.commitId = commitId;
    created.buildLabels = buildLabels;
    created.shard = no;
    created.freeze(application);
    created.recordedCases = recordedCases;
    created.move(BuildState.QUEUED, now, "shard " + no + " of build " + id);
    shards++;
    return created;
  }

  /**
   * Creates an analysis of this build.
   *
   * @param maxCases maximum number of further cases
   */
  Build addAnalysis(String analysisId, BuildKind analysis, int maxCases, Instant now) {
    require(
        kind == BuildKind.TEST && analysis != BuildKind.TEST && state == BuildState.DONE,
        "analysed");
    Build created = new Build();
    created.id = analysisId;
    created.activityId = activityId;
    created.activityName = activityName;
    created.suiteId = suiteId;
    created.model = model;
    created.kind = analysis;
    created.analysedId = id;
    created.priority = priority;
    created.maxAttempts = maxAttempts;
    created.created = now;
    created.commitId = commitId;
    created.buildLabels = buildLabels;
    created.freeze(
        new FrozenApplication(
            language, requirements().with(new Requirement.Analyses()), files, maxCases, maxCases));
    created.move(BuildState.QUEUED, now, analysis.words() + " of build " + id);
    return created;
  }

  private void freeze(FrozenApplication application) {
    language = application.language();
    requirements = application.requirements().text();
    files.addAll(application.files());
    cases = new CaseProgress(application.cases(), application.lastCase());
  }

  /** Assigns the build to an agent. */
  void lease(int attemptNo, String toAgent, Instant now) {
    require(state == BuildState.QUEUED, "assigned to an agent");
    attempt = attemptNo;
    agent = toAgent;
    started = started == null ? now : started;
    cases.restart();
    move(BuildState.LEASED, now, "assigned to agent " + toAgent);
  }

  /** Stores the state that the agent reports. */
  void advance(BuildState to, Instant now) {
    if (!to.isActive() || to.compareTo(state) < 0) {
      throw RequestException.malformed("A build that is " + state + " cannot become " + to + ".");
    }
    require(state.isActive(), "updated");
    if (to != state) {
      move(to, now, "reported by agent " + agent);
    }
  }

  /**
   * Counts finished cases.
   *
   * @return the numbers of those that were not counted before
   */
  Set<Integer> addCases(Collection<Integer> numbers) {
    require(state.isActive(), "updated");
    return cases.add(numbers);
  }

  /** Ends the build with an accepted result. */
  void complete(TestResult result, Instant now) {
    require(state.isActive(), "completed");
    Summary summary = result.summary();
    counts = CaseCounts.of(summary);
    if (result.isSuspect()) {
      String reasons = String.join("\n", result.suspicions());
      suspicions =
          reasons.length() <= MAX_SUSPICIONS ? reasons : reasons.substring(0, MAX_SUSPICIONS);
    }
    cases.set(summary.total() - summary.dont());
    finished = now;
    move(BuildState.DONE, now, "result accepted");
  }

  /** Ends an analysis whose report was accepted. */
  void completeAnalysis(Instant now) {
    require(state.isActive() && kind != BuildKind.TEST, "completed");
    finished = now;
    move(BuildState.DONE, now, "report accepted");
  }

  /** Ends the build without a result. */
  void fail(BuildFailure failure, Instant now) {
    require(!state.isOver(), "failed");
    failureCategory = failure.category();
    failureMessage = failure.message();
    problems.clear();
    problems.addAll(failure.problems());
    finished = now;
    move(BuildState.FAILED, now, failure.message());
  }

  void cancel(String cause, Instant now) {
    require(!state.isOver(), "cancelled");
    finished = now;
    move(BuildState.CANCELLED, now, cause);
  }

  /** Counts a failure that an agent reported; returns the number of earlier failures. */
  int countFailure() {
    return failures++;
  }

  /**
   * Queues the build for another attempt after an infrastructure failure.
   *
   * @param earliest time of the next attempt at the earliest
   */
  void queueAgain(String cause, Instant earliest, Instant now) {
    require(state.isActive(), "queued again");
    agent = null;
    notBefore = earliest;
    move(BuildState.QUEUED, now, cause);
  }

  /** Updates the progress from the shards; starts the build when its first shard has started. */
  void updateFromShards(int finishedCases, Instant now) {
    if (state == BuildState.QUEUED) {
      started = now;
      move(BuildState.RUNNING, now, "the first of " + shards + " shards was assigned to an agent");
    }
    cases.set(finishedCases);
  }

  private void move(BuildState to, Instant now, String cause) {
    state = to;
    transitions.add(new Transition(attempt, to, now, cause));
  }

  private void require(boolean allowed, String change) {
    if (!allowed) {
      throw RequestException.conflict(
          "Build " + id + " is " + state + " and cannot be " + change + ".");
    }
  }

  public String id() {
    return id;
  }

  public String activityId() {
    return activityId;
  }

  public String activityName() {
    return activityName;
  }

  public String suiteId() {
    return suiteId;
  }

  public String model() {
    return model;
  }

  /** Which state of the sources it tests. */
  public BuildSource source() {
    return BuildSource.parse(commitId, buildLabels);
  }

  public String language() {
    return language;
  }

  /** What the agent must provide. */
  public Requirements requirements() {
    return Requirements.parse(requirements);
  }

  public int priority() {
    return priority;
  }

  /** Time of the next attempt at the earliest; empty if there is no delay. */
  public Optional<Instant> notBefore() {
    return Optional.ofNullable(notBefore);
  }

  /** The cases that were requested, such as 9,12-20; empty for all. */
  public Optional<String> caseNumbers() {
    return Optional.ofNullable(caseNumbers);
  }

  /** Which cases are recorded in the simulation. */
  public RecordedCases recordedCases() {
    return recordedCases;
  }

  public int maxAttempts() {
    return maxAttempts;
  }

  public BuildKind kind() {
    return kind;
  }

  /** The build that is analysed; empty for a build that executes cases. */
  public Optional<String> analysedId() {
    return Optional.ofNullable(analysedId);
  }

  /** Whether its failures are explained when it ends. */
  public boolean explainsFailures() {
    return explainFailures;
  }

  /** Whether its verdicts can be trusted and some of them are FAIL or ERROR. */
  public boolean hasFailures() {
    return counts != null && suspicions == null && counts.fail() + counts.error() > 0;
  }

  /** The build that this shard belongs to; empty for a whole build. */
  public Optional<String> parentId() {
    return Optional.ofNullable(parentId);
  }

  /** The number of this shard, from 1; 0 for a whole build. */
  public int shard() {
    return shard;
  }

  /** The number of shards; 0 for a build that is executed by one agent. */
  public int shards() {
    return shards;
  }

  public BuildState state() {
    return state;
  }

  /** The number of the latest attempt, from 1; 0 if there is none. */
  public int attempt() {
    return attempt;
  }

  public Optional<String> agent() {
    return Optional.ofNullable(agent);
  }

  public Instant created() {
    return created;
  }

  public Optional<Instant> started() {
    return Optional.ofNullable(started);
  }

  public Optional<Instant> finished() {
    return Optional.ofNullable(finished);
  }

  public long version() {
    return version == null ? 0 : version;
  }

  public int casesTotal() {
    return cases.total();
  }

  public int casesDone() {
    return cases.done();
  }

  /** The fire time that requested the build; empty if it was not requested by a schedule. */
  public Optional<Reservation> reservation() {
    return scheduleId == null || fireTime == null
        ? Optional.empty()
        : Optional.of(new Reservation(scheduleId, fireTime));
  }

  public Optional<CaseCounts> counts() {
    return Optional.ofNullable(counts);
  }

  /** Why the verdicts cannot be trusted; empty if they can. */
  public List<String> suspicions() {
    return suspicions == null ? List.of() : suspicions.lines().toList();
  }

  public Optional<BuildFailure> failure() {
    return failureCategory == null || failureMessage == null
        ? Optional.empty()
        : Optional.of(new BuildFailure(failureCategory, failureMessage, problems));
  }

  public List<StoredFile> files() {
    return List.copyOf(files);
  }

  public List<Transition> transitions() {
    return List.copyOf(transitions);
  }
}
