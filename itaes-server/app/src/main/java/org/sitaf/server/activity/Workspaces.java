package org.sitaf.server.activity;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.UUID;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.model.TestModel;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.quota.Quotas;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.web.Requests;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/**
 * The activities on the server. Whatever is stored here was read and verified as a whole before.
 */
@Service
public class Workspaces {
  /** How often a change of whatever version is made again when somebody else was faster. */
  private static final int MAX_ATTEMPTS = 10;

  private final WorkspaceRepository workspaces;
  private final StoredFiles contents;
  private final Quotas quotas;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  Workspaces(
      WorkspaceRepository workspaces,
      StoredFiles contents,
      Quotas quotas,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      Clock clock) {
    this.workspaces = workspaces;
    this.contents = contents;
    this.quotas = quotas;
    this.transaction = transaction;
    this.events = events;
    this.clock = clock;
  }

  /**
   * The activity, read from its files.
   *
   * @throws Refusal when there is none of that id
   */
  public Activity activity(String id) {
    return Activity.read(contents.load(files(id)));
  }

  /**
   * The name of an activity.
   *
   * @throws Refusal when there is none of that id
   */
  public String name(String id) {
    return inspect(id, Workspace::name);
  }

  /**
   * A model of an activity.
   *
   * @throws Refusal when it has none of that name
   */
  public static TestModel model(Activity activity, String name) {
    return activity.model(name).orElseThrow(() -> Refusal.notFound("model", name));
  }

  /** Runs with the workspace of an id, within a transaction. */
  <T> T inspect(String id, Function<Workspace, T> view) {
    return required(transaction.execute(status -> view.apply(find(id))));
  }

  /** A page of the workspaces, of one name or all, each viewed within the transaction. */
  <T> Page<T> list(@Nullable String name, Pageable page, Function<Workspace, T> view) {
    return required(
        transaction.execute(
            status ->
                (name == null ? workspaces.findAll(page) : workspaces.findByName(name, page))
                    .map(view)));
  }

  /**
   * Verifies and stores the files of an activity; nothing is stored when anything is wrong with
   * them.
   */
  String create(FileTree tree) {
    Activity activity = Activity.read(tree);
    String id = UUID.randomUUID().toString();
    return quotas.storing(
        tree,
        null,
        () -> {
          List<StoredFile> files = contents.store(activity.files());
          transaction.executeWithoutResult(
              status -> {
                workspaces.saveAndFlush(new Workspace(id, activity, files, now()));
                quotas.ownActivity(id);
              });
          return id;
        });
  }

  /**
   * Makes sure that there is an activity.
   *
   * @throws Refusal when there is none of that id
   */
  void require(String id) {
    files(id);
  }

  /** The document of a model. */
  byte[] modelDocument(String id, String name) {
    return content(id, modelPath(id, name));
  }

  /**
   * Replaces the document of a model, when the activity is valid with it.
   *
   * @param expected the version that the author of the document saw
   * @throws Refusal when the activity has another version
   */
  void replaceModel(String id, String name, byte[] document, Requests.Expected expected) {
    change(
        id,
        expected,
        tree -> {
          Map<String, byte[]> files = new HashMap<>();
          tree.paths().forEach(path -> files.put(path, tree.content(path).orElseThrow()));
          files.put(modelPath(id, name), document);
          return FileTree.of(files);
        });
  }

  /**
   * Changes several files, when the activity is valid with the changes.
   *
   * @param expected the version that the author of the changes saw
   * @throws Refusal when the activity has another version
   */
  void change(String id, FileChanges changes, Requests.Expected expected) {
    change(id, expected, changes::applyTo);
  }

  /**
   * Replaces the files by what a change makes of them. They are replaced only while the activity
   * has the version that was read, so that no change of somebody else is undone; where any version
   * was expected, the change is made again to the newer files.
   */
  private void change(String id, Requests.Expected expected, UnaryOperator<FileTree> change) {
    for (int attempt = 1; ; attempt++) {
      Snapshot seen = inspect(id, w -> new Snapshot(w.version(), w.files()));
      try {
        expected.require("activity", seen.version());
        FileTree changed = change.apply(contents.load(seen.files()));
        replace(id, changed, Requests.Expected.version(seen.version()));
        return;
      } catch (Refusal e) {
        boolean repeat = expected.isAny() && e.reason() == Refusal.Reason.OUTDATED;
        if (!repeat || attempt == MAX_ATTEMPTS) {
          throw e;
        }
      }
    }
  }

  private record Snapshot(long version, List<StoredFile> files) {}

  FileTree tree(String id) {
    return contents.load(files(id));
  }

  byte[] content(String id, String path) {
    StoredFile file =
        files(id).stream()
            .filter(f -> f.path().equals(path))
            .findFirst()
            .orElseThrow(() -> Refusal.notFound("file", path));
    return contents.content(file.sha256());
  }

  void delete(String id) {
    transaction.executeWithoutResult(
        status -> {
          Workspace workspace = find(id);
          events.publishEvent(new ActivityDeletion(id));
          workspaces.delete(workspace);
        });
  }

  /** Puts other files into the place of the activity's. */
  void replace(String id, FileTree tree, Requests.Expected expected) {
    Activity activity = Activity.read(tree);
    quotas.storing(
        tree,
        id,
        () -> {
          List<StoredFile> files = contents.store(tree);
          transaction.executeWithoutResult(
              status -> {
                Workspace workspace =
                    workspaces
                        .findForChange(id)
                        .orElseThrow(() -> Refusal.notFound("activity", id));
                expected.require("activity", workspace.version());
                workspace.replace(activity, files, now());
                workspaces.saveAndFlush(workspace);
                quotas.ownActivity(id);
              });
          return id;
        });
  }

  private List<StoredFile> files(String id) {
    return inspect(id, Workspace::files);
  }

  private String modelPath(String id, String name) {
    return inspect(id, Workspace::models).stream()
        .filter(m -> m.name().equals(name))
        .findFirst()
        .orElseThrow(() -> Refusal.notFound("model", name))
        .path();
  }

  private Workspace find(String id) {
    return workspaces.findById(id).orElseThrow(() -> Refusal.notFound("activity", id));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  private static <T> T required(@Nullable T result) {
    return Objects.requireNonNull(result);
  }
}
