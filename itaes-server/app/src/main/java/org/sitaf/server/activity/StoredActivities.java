package org.sitaf.server.activity;

import java.time.Clock;
import java.time.Instant;
import java.time.temporal.ChronoUnit;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.UUID;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.quota.Quotas;
import org.sitaf.server.web.Requests;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.stereotype.Service;
import org.springframework.transaction.support.TransactionTemplate;

/** The activities on the server. Activities are verified before they are stored. */
@Service
public class StoredActivities {
  /** Maximum number of attempts of a change that conflicts with concurrent changes. */
  private static final int MAX_ATTEMPTS = 10;

  private final StoredActivityRepository activities;
  private final StoredFiles contents;
  private final RosPackages packages;
  private final Quotas quotas;
  private final TransactionTemplate transaction;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  StoredActivities(
      StoredActivityRepository activities,
      StoredFiles contents,
      RosPackages packages,
      Quotas quotas,
      TransactionTemplate transaction,
      ApplicationEventPublisher events,
      Clock clock) {
    this.activities = activities;
    this.contents = contents;
    this.packages = packages;
    this.quotas = quotas;
    this.transaction = transaction;
    this.events = events;
    this.clock = clock;
  }

  /**
   * Reads an activity from its stored files.
   *
   * @throws RequestException if there is no activity with this id
   */
  public Activity activity(String id) {
    return packages.read(contents.load(files(id)));
  }

  /** Reads an activity that is not stored. */
  public Activity read(FileTree files) {
    return packages.read(files);
  }

  /**
   * Returns the name of an activity.
   *
   * @throws RequestException if there is no activity with this id
   */
  public String name(String id) {
    return inspect(id, StoredActivity::name);
  }

  /**
   * Returns a model of an activity.
   *
   * @throws RequestException if there is no model with this name
   */
  public static TestModel model(Activity activity, String name) {
    return activity.model(name).orElseThrow(() -> RequestException.notFound("model", name));
  }

  /** Applies a function to an activity within a transaction. */
  <T> T inspect(String id, Function<StoredActivity, T> view) {
    return required(transaction.execute(status -> view.apply(find(id))));
  }

  /** Returns a page of the activities with all tags; a name and a text of null mean all. */
  <T> Page<T> list(
      @Nullable String name,
      @Nullable String search,
      Set<String> tags,
      Pageable page,
      Function<StoredActivity, T> view) {
    return required(transaction.execute(status -> page(name, search, tags, page).map(view)));
  }

  private Page<StoredActivity> page(
      @Nullable String name, @Nullable String search, Set<String> tags, Pageable page) {
    if (!tags.isEmpty()) {
      String text = search == null ? "" : search.toLowerCase(Locale.ROOT);
      return activities.findTagged(name == null ? "" : name, text, tags, tags.size(), page);
    }
    if (name != null) {
      return activities.findByName(name, page);
    }
    return search == null
        ? activities.findAll(page)
        : activities.findContaining(search.toLowerCase(Locale.ROOT), page);
  }

  /**
   * Verifies and stores an activity.
   *
   * @return its id
   * @throws org.sitaf.core.diagnostic.InvalidInputException if it has errors
   */
  public String create(FileTree tree) {
    Activity activity = packages.read(tree);
    String id = UUID.randomUUID().toString();
    return quotas.storing(
        tree,
        null,
        () -> {
          List<StoredFile> files = contents.store(activity.files());
          transaction.executeWithoutResult(
              status -> {
                activities.saveAndFlush(new StoredActivity(id, activity, files, now()));
                quotas.ownActivity(id);
              });
          return id;
        });
  }

  /**
   * Checks that an activity exists.
   *
   * @throws RequestException if there is no activity with this id
   */
  void require(String id) {
    files(id);
  }

  /** Returns the document of a model. */
  byte[] modelDocument(String id, String name) {
    return content(id, modelPath(id, name));
  }

  /**
   * Replaces the document of a model, if the activity has no errors with it.
   *
   * @param expected the version to which the change applies
   * @throws RequestException if the activity has another version
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
   * Changes several files, if the activity has no errors after the changes.
   *
   * @param expected the version to which the changes apply
   * @throws RequestException if the activity has another version
   */
  void change(String id, FileChanges changes, Requests.Expected expected) {
    change(id, expected, changes::applyTo);
  }

  /**
   * Adds files, which replace those of the same paths, if the activity has no errors with them.
   *
   * @param expected the version to which they are added
   * @throws RequestException if the activity has another version
   */
  void add(String id, FileTree files, Requests.Expected expected) {
    change(
        id,
        expected,
        tree -> {
          try {
            return tree.with("", files);
          } catch (IllegalArgumentException e) {
            throw InvalidInputException.of("the added files", String.valueOf(e.getMessage()));
          }
        });
  }

  /**
   * Applies a change to the files. The files are only replaced if the activity still has the
   * version that was read, so that no concurrent change is lost. If the caller expects any version,
   * the change is repeated with the newer files.
   */
  private void change(String id, Requests.Expected expected, UnaryOperator<FileTree> change) {
    for (int attempt = 1; ; attempt++) {
      Snapshot current = inspect(id, a -> new Snapshot(a.version(), a.files()));
      try {
        expected.require("activity", current.version());
        FileTree changed = change.apply(contents.load(current.files()));
        replace(id, changed, Requests.Expected.version(current.version()));
        return;
      } catch (RequestException e) {
        boolean repeat = expected.isAny() && e.reason() == RequestException.Reason.OUTDATED;
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
            .orElseThrow(() -> RequestException.notFound("file", path));
    return contents.content(file.sha256());
  }

  void delete(String id) {
    transaction.executeWithoutResult(
        status -> {
          StoredActivity stored = find(id);
          events.publishEvent(new ActivityDeletion(id));
          activities.delete(stored);
        });
  }

  /**
   * Replaces the files of an activity by those of its source, which is no edit of a person.
   *
   * @throws org.sitaf.core.diagnostic.InvalidInputException if they have errors
   */
  public void update(String id, FileTree tree) {
    Activity activity = packages.read(tree);
    List<StoredFile> files = contents.store(tree);
    transaction.executeWithoutResult(
        status -> {
          StoredActivity stored =
              activities
                  .findForUpdate(id)
                  .orElseThrow(() -> RequestException.notFound("activity", id));
          stored.replace(activity, files, now());
          activities.saveAndFlush(stored);
        });
  }

  /** The tags of all activities in ascending order. */
  List<Tags.Use> tags() {
    return activities.findTags();
  }

  /** Replaces the tags of an activity. Its version stays, because the files do not change. */
  void tag(String id, Set<String> tags) {
    transaction.executeWithoutResult(
        status ->
            activities
                .findForUpdate(id)
                .orElseThrow(() -> RequestException.notFound("activity", id))
                .tag(tags));
  }

  /** Replaces the files of an activity. */
  void replace(String id, FileTree tree, Requests.Expected expected) {
    events.publishEvent(new ActivityEdit(id));
    Activity activity = packages.read(tree);
    quotas.storing(
        tree,
        id,
        () -> {
          List<StoredFile> files = contents.store(tree);
          transaction.executeWithoutResult(
              status -> {
                StoredActivity stored =
                    activities
                        .findForUpdate(id)
                        .orElseThrow(() -> RequestException.notFound("activity", id));
                expected.require("activity", stored.version());
                stored.replace(activity, files, now());
                activities.saveAndFlush(stored);
                quotas.ownActivity(id);
              });
          return id;
        });
  }

  private List<StoredFile> files(String id) {
    return inspect(id, StoredActivity::files);
  }

  private String modelPath(String id, String name) {
    return inspect(id, StoredActivity::models).stream()
        .filter(m -> m.name().equals(name))
        .findFirst()
        .orElseThrow(() -> RequestException.notFound("model", name))
        .path();
  }

  private StoredActivity find(String id) {
    return activities.findById(id).orElseThrow(() -> RequestException.notFound("activity", id));
  }

  private Instant now() {
    return clock.instant().truncatedTo(ChronoUnit.MICROS);
  }

  private static <T> T required(@Nullable T result) {
    return Objects.requireNonNull(result);
  }
}
