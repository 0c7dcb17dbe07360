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
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.RecordedCases;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.build.request.Reservation;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.suite.SuiteOrigin;

/**
 * A request to execute a suite, and what became of it. The test application is frozen with the
 * request.
 */
@Entity
public class Build {
  private static final int MAX_SUSPICIONS = 8000;

  @Id private String id;

  @Column(name = "workspace_id")
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

  /** Null until it is stored, which is how the persistence provider knows that it is new. */
  @Version private @Nullable Long version;

  private int priority;
  private int maxAttempts;
  private @Nullable Instant notBefore;
  private String requirements;
  private @Nullable String parentId;
  private int part;
  private int parts;

  @Enumerated(EnumType.STRING)
  private RecordedCases recordedCases;

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
   * A build that waits.
   *
   * @param application what will be executed, frozen with the request
   * @param maxAttempts how often it is tried while only the infrastructure fails
   * @param reservation null for a build at once
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
    if (reservation != null) {
      this.scheduleId = reservation.scheduleId();
      this.fireTime = reservation.fireTime();
    }
    move(BuildState.QUEUED, now, reservation == null ? "requested" : "reserved time reached");
  }

  /** A part of this build: some of its cases, as a build of its own. */
  Build part(String partId, int no, FrozenApplication application, Instant now) {
    Build made = new Build();
    made.id = partId;
    made.activityId = activityId;
    made.activityName = activityName;
    made.suiteId = suiteId;
    made.model = model;
    made.priority = priority;
    made.maxAttempts = maxAttempts;
    made.created = now;
    made.parentId = id;
    made.part = no;
    made.freeze(application);
    made.recordedCases = recordedCases;
    made.move(BuildState.QUEUED, now, "part " + no + " of build " + id);
    parts++;
    return made;
  }

  private void freeze(FrozenApplication application) {
    language = application.language();
    requirements = application.requirements().text();
    files.addAll(application.files());
    cases = new CaseProgress(application.cases(), application.lastCase());
  }

  /** Gives it to an agent. */
  void lease(int attemptNo, String toAgent, Instant now) {
    require(state == BuildState.QUEUED, "given to an agent");
    attempt = attemptNo;
    agent = toAgent;
    started = started == null ? now : started;
    cases.restart();
    move(BuildState.LEASED, now, "given to agent " + toAgent);
  }

  /** Follows what the agent reports; a state that is reached already changes nothing. */
  void advance(BuildState to, Instant now) {
    if (!to.isActive() || to.compareTo(state) < 0) {
      throw Refusal.malformed("A build that is " + state + " cannot become " + to + ".");
    }
    require(state.isActive(), "worked on");
    if (to != state) {
      move(to, now, "reported by agent " + agent);
    }
  }

  /**
   * Notes cases that have ended; a case that was noted before is not counted again.
   *
   * @return those that were not noted before
   */
  Set<Integer> noteCases(Collection<Integer> numbers) {
    require(state.isActive(), "worked on");
    return cases.note(numbers);
  }

  /** The result is accepted. */
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

  /** There will be no result. */
  void fail(BuildFailure failure, Instant now) {
    require(!state.isOver(), "failed");
    failureCategory = failure.category();
    failureMessage = failure.message();
    problems.clear();
    problems.addAll(failure.problems());
    finished = now;
    move(BuildState.FAILED, now, failure.message());
  }

  /** Nobody wants it any more. */
  void cancel(String cause, Instant now) {
    require(!state.isOver(), "cancelled");
    finished = now;
    move(BuildState.CANCELLED, now, cause);
  }

  /** Counts a failure that an agent reports; answers how many there were before it. */
  int noteFailure() {
    return failures++;
  }

  /**
   * The attempt failed for a reason outside the build: another one may succeed.
   *
   * @param earliest when it may be given to an agent again
   */
  void queueAgain(String cause, Instant earliest, Instant now) {
    require(state.isActive(), "queued again");
    agent = null;
    notBefore = earliest;
    move(BuildState.QUEUED, now, cause);
  }

  /** Follows its parts: the first that begins has it begin, and their cases are its cases. */
  void followParts(int casesOfParts, Instant now) {
    if (state == BuildState.QUEUED) {
      started = now;
      move(BuildState.RUNNING, now, "the first of its " + parts + " parts was given to an agent");
    }
    cases.set(casesOfParts);
  }

  private void move(BuildState to, Instant now, String cause) {
    state = to;
    transitions.add(new Transition(attempt, to, now, cause));
  }

  private void require(boolean allowed, String change) {
    if (!allowed) {
      throw Refusal.conflict("Build " + id + " is " + state + " and cannot be " + change + ".");
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

  public String language() {
    return language;
  }

  /** What an agent must have for it. */
  public Requirements requirements() {
    return Requirements.parse(requirements);
  }

  public int priority() {
    return priority;
  }

  /** When it may be given to an agent at the earliest; empty for at once. */
  public Optional<Instant> notBefore() {
    return Optional.ofNullable(notBefore);
  }

  /** Of which cases it is recorded what moves in the simulation. */
  public RecordedCases recordedCases() {
    return recordedCases;
  }

  public int maxAttempts() {
    return maxAttempts;
  }

  /** The build that this one is a part of. */
  public Optional<String> parentId() {
    return Optional.ofNullable(parentId);
  }

  /** Which part of its parent it is, from 1; 0 for a whole build. */
  public int part() {
    return part;
  }

  /** Over how many parts its cases are spread; 0 for a build that one agent executes. */
  public int parts() {
    return parts;
  }

  public BuildState state() {
    return state;
  }

  /** The latest attempt, from 1; 0 before the first. */
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

  /** What reserved it; empty for a build at once. */
  public Optional<Reservation> reservation() {
    return scheduleId == null || fireTime == null
        ? Optional.empty()
        : Optional.of(new Reservation(scheduleId, fireTime));
  }

  public Optional<CaseCounts> counts() {
    return Optional.ofNullable(counts);
  }

  /** Why its verdicts are not to be trusted; empty where they are. */
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
