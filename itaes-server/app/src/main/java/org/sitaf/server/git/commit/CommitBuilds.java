package org.sitaf.server.git.commit;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Semaphore;
import java.util.stream.Collectors;
import org.eclipse.jgit.errors.MissingObjectException;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.ros.RosImplementation;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.build.Builds;
import org.sitaf.server.build.request.AgentConstraints;
import org.sitaf.server.build.request.BuildOptions;
import org.sitaf.server.build.request.BuildSource;
import org.sitaf.server.build.request.RealDevices;
import org.sitaf.server.build.request.Requirements;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.git.remote.History;
import org.sitaf.server.git.source.GitSource;
import org.sitaf.server.git.source.GitSources;
import org.sitaf.server.git.source.SourceRows;
import org.sitaf.server.suite.SuiteOrigin;
import org.sitaf.server.suite.Suites;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * Makes builds of commits. A model is built unless an earlier build of the source read exactly the
 * same bytes with the same toolchains.
 */
@Service
class CommitBuilds {
  /** Commits of one push that are recorded; more of them are left out. */
  private static final int MAX_NEW = 500;

  /** Known commits among which the last one is searched after a force-push. */
  private static final int MAX_KNOWN = 5000;

  /** Commits of searches are built when nothing else waits. */
  private static final BuildOptions FOR_BISECTION =
      new BuildOptions(
          -50, 1, null, AgentConstraints.NONE, null, null, false, RosImplementation.INCLUDED);

  /** Whole activities in memory. */
  private static final int AT_ONCE = 2;

  private final CommitRows commits;
  private final KnownResults results;
  private final SourceRows sourceRows;
  private final GitSources sources;
  private final StoredActivities activities;
  private final Suites suites;
  private final Builds builds;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final Semaphore memory = new Semaphore(AT_ONCE, true);

  CommitBuilds(
      CommitRows commits,
      KnownResults results,
      SourceRows sourceRows,
      GitSources sources,
      StoredActivities activities,
      Suites suites,
      Builds builds,
      TransactionTemplate transaction,
      ApplicationEventPublisher events) {
    this.commits = commits;
    this.results = results;
    this.sourceRows = sourceRows;
    this.sources = sources;
    this.activities = activities;
    this.suites = suites;
    this.builds = builds;
    this.transaction = transaction;
    this.events = events;
  }

  /** Records the commits that a fetch brought. */
  void record(GitSource source) throws IOException {
    try (History history = History.open(sources.copy(source.id()))) {
      String head = history.resolve(source.reference()).orElse(null);
      if (head == null || head.equals(source.head())) {
        return;
      }
      Map<String, GitCommit> known =
          commits.branch(source.id(), MAX_KNOWN).stream()
              .collect(Collectors.toMap(GitCommit::sha, c -> c));
      History.Line line = history.line(head, known.keySet(), MAX_NEW);
      GitCommit last = line.known().map(known::get).orElse(null);
      transaction.executeWithoutResult(status -> record(source, head, line, last));
    }
  }

  private void record(GitSource source, String head, History.Line line, @Nullable GitCommit last) {
    commits.replacedAfter(source.id(), last == null ? -1 : last.position());
    // Nothing is compared with commits before the first one or before an unrelated history.
    List<History.Commit> added =
        last == null && !line.commits().isEmpty()
            ? line.commits().subList(line.commits().size() - 1, line.commits().size())
            : line.commits();
    if (source.policy() == GitSource.Policy.LATEST && !added.isEmpty()) {
      commits.skipWaiting(source.id(), 0);
    }
    String base =
        commits.branch(source.id(), MAX_KNOWN).stream()
            .filter(c -> c.state() != GitCommit.State.SKIPPED)
            .map(GitCommit::id)
            .findFirst()
            .orElse(null);
    long position = commits.nextPosition(source.id(), 0);
    for (int i = 0; i < added.size(); i++) {
      boolean built = source.policy() == GitSource.Policy.EVERY || i == added.size() - 1;
      // A commit that one force-push removed and another one brought back is built again.
      commits.deleteReplaced(source.id(), added.get(i).id());
      String id =
          commits.insert(
              source.id(),
              0,
              false,
              added.get(i),
              position + i,
              built ? GitCommit.State.WAITING : GitCommit.State.SKIPPED,
              base);
      base = built ? id : base;
    }
    sourceRows.head(source.id(), head);
  }

  /** Requests the builds of all commits that wait. */
  void buildWaiting(GitSource source) throws IOException, InterruptedException {
    for (GitCommit commit : commits.waiting(source.id())) {
      memory.acquire();
      try {
        build(source, commit);
      } finally {
        memory.release();
      }
    }
  }

  private record Planned(SuiteOrigin origin, TestApplication application, String digest) {}

  private void build(GitSource source, GitCommit commit) throws IOException {
    List<Planned> planned;
    try (History history = History.open(sources.copy(source.id()))) {
      FileTree files = history.files(commit.sha(), source.folder());
      Activity activity = activities.read(files);
      if (commit.requestNo() == 0 && commit.sha().equals(source.head())) {
        activities.update(source.activityId(), files);
      }
      planned = plan(source, activity, models(commit, activity));
    } catch (InvalidInputException | ComputationTimeoutException e) {
      invalid(commit, String.valueOf(e.getMessage()));
      return;
    } catch (MissingObjectException e) {
      if (!commit.isOfBisection()) {
        throw e;
      }
      // No later fetch brings it back, and the branch must not wait for it.
      invalid(commit, "The server's copy of the repository no longer has all files of it.");
      return;
    } catch (RequestException e) {
      if (e.reason() == RequestException.Reason.BUSY
          || e.reason() == RequestException.Reason.DISK_FULL) {
        throw e;
      }
      invalid(commit, String.valueOf(e.getMessage()));
      return;
    }
    Set<String> known = new HashSet<>();
    commits.cells(commit.id()).forEach(cell -> known.add(cell.model()));
    for (int i = 0; i < planned.size(); i++) {
      if (known.add(planned.get(i).origin().model())) {
        request(source, commit, planned.get(i), i);
      }
    }
    transaction.executeWithoutResult(
        status -> {
          if (commits.move(commit.id(), GitCommit.State.WAITING, GitCommit.State.BUILDING, null)) {
            events.publishEvent(new CommitEvent.Started(commit.id()));
          }
        });
  }

  private void invalid(GitCommit commit, String problem) {
    transaction.executeWithoutResult(
        status -> {
          if (commits.move(
              commit.id(), GitCommit.State.WAITING, GitCommit.State.INVALID, problem)) {
            events.publishEvent(new CommitEvent.Ended(commit.id()));
          }
        });
  }

  private List<TestModel> models(GitCommit commit, Activity activity) {
    if (!commit.isOfBisection()) {
      return activity.models();
    }
    Set<String> needed = results.modelsOfBisection(commit.sourceId(), -commit.requestNo());
    return activity.models().stream().filter(model -> needed.contains(model.name())).toList();
  }

  private List<Planned> plan(GitSource source, Activity activity, List<TestModel> models) {
    List<Planned> planned = new ArrayList<>();
    String toolchains = String.join("\n", results.toolchains());
    for (TestModel model : models) {
      GeneratedSuite generated = suites.generate(model);
      TestApplication application =
          InterfaceTestApplicationGenerator.generate(activity, model, generated.suite());
      RealDevices.requireAllowed(
          Requirements.of(application, BuildOptions.DEFAULT.agent()), BuildOptions.DEFAULT);
      SuiteOrigin origin =
          new SuiteOrigin(
              source.activityId(),
              activity.profile().name(),
              suiteId(source.activityId(), model.name(), generated),
              model.name());
      planned.add(new Planned(origin, application, digest(application, toolchains)));
    }
    return planned;
  }

  private String suiteId(String activityId, String model, GeneratedSuite generated) {
    String sha256 = StoredFiles.sha256(Suites.document(generated.suite()));
    Optional<String> known = results.suite(activityId, model, sha256);
    if (known.isPresent()) {
      return known.get();
    }
    String id = suites.store(activityId, generated);
    results.insertSuite(activityId, model, sha256, id);
    return id;
  }

  /**
   * Covers every byte that the build can read: all files of the activity with its lock file, the
   * generated harness, the model and the cases, and the toolchains of all agents.
   */
  private static String digest(TestApplication application, String toolchains) {
    FileTree files = application.files();
    StringBuilder text = new StringBuilder(toolchains).append('\n');
    for (String path : files.paths()) {
      text.append(path)
          .append(' ')
          .append(StoredFiles.sha256(files.content(path).orElseThrow()))
          .append('\n');
    }
    return StoredFiles.sha256(text.toString().getBytes(StandardCharsets.UTF_8));
  }

  private void request(GitSource source, GitCommit commit, Planned planned, int position) {
    String model = planned.origin().model();
    Optional<KnownResults.Reusable> same = results.reusable(commit, model, planned.digest());
    if (same.isPresent()) {
      commits.insertCell(
          commit.id(), model, position, planned.digest(), same.get().buildId(), same.get().sha());
      return;
    }
    String unused =
        builds.request(
            planned.origin(),
            planned.application(),
            commit.isOfBisection() ? FOR_BISECTION : BuildOptions.DEFAULT,
            new BuildSource(commit.sha(), labels(source, commit)),
            build ->
                commits.insertCell(commit.id(), model, position, planned.digest(), build, null));
  }

  private static Map<String, String> labels(GitSource source, GitCommit commit) {
    if (commit.isOfBisection()) {
      return Map.of("bisection", Integer.toString(-commit.requestNo()));
    }
    return commit.requestNo() == 0
        ? Map.of("branch", source.branch())
        : Map.of("request", Integer.toString(commit.requestNo()));
  }
}
