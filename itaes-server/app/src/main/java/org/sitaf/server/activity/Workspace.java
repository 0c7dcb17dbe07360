package org.sitaf.server.activity;

import jakarta.persistence.CollectionTable;
import jakarta.persistence.ElementCollection;
import jakarta.persistence.Entity;
import jakarta.persistence.Id;
import jakarta.persistence.JoinColumn;
import jakarta.persistence.OrderBy;
import jakarta.persistence.OrderColumn;
import jakarta.persistence.Version;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.server.file.StoredFile;

/**
 * One component under test on the server: the files of its activity, verified, and what they say.
 */
@Entity
class Workspace {
  private static final int MAX_NAME = 200;
  private static final int MAX_CLASS = 1000;
  private static final int MAX_TEXT = 4000;
  private static final int SHOWN = 60;

  @Id private String id;
  private String name;
  private String description;
  private String language;
  private String componentClass;
  private Instant created;
  private Instant updated;

  /** Null until it is stored, which is how the persistence provider knows that it is new. */
  @Version private @Nullable Long version;

  @ElementCollection
  @CollectionTable(name = "workspace_file", joinColumns = @JoinColumn(name = "workspace_id"))
  @OrderBy("path")
  private Set<StoredFile> files = new LinkedHashSet<>();

  @ElementCollection
  @CollectionTable(name = "workspace_model", joinColumns = @JoinColumn(name = "workspace_id"))
  @OrderColumn(name = "position")
  private List<WorkspaceModel> models = new ArrayList<>();

  @ElementCollection
  @CollectionTable(name = "workspace_method", joinColumns = @JoinColumn(name = "workspace_id"))
  @OrderColumn(name = "position")
  private List<WorkspaceMethod> methods = new ArrayList<>();

  /** For the persistence provider. */
  @SuppressWarnings("NullAway")
  protected Workspace() {
    id = "";
    name = "";
    description = "";
    language = "";
    componentClass = "";
    created = Instant.EPOCH;
    updated = Instant.EPOCH;
  }

  /** A new workspace of a verified activity whose files are stored. */
  Workspace(String id, Activity activity, List<StoredFile> files, Instant now) {
    this();
    this.id = id;
    this.created = now;
    replace(activity, files, now);
  }

  /** Puts another state of the activity into the place of the present one. */
  final void replace(Activity activity, List<StoredFile> newFiles, Instant now) {
    requireStorable(activity);
    name = activity.profile().name();
    description = activity.profile().description();
    language = activity.profile().component().language().spelling();
    componentClass = activity.profile().component().className();
    updated = now;
    files.removeIf(old -> !newFiles.contains(old));
    files.addAll(newFiles);
    models.clear();
    for (TestModel model : activity.models()) {
      models.add(
          new WorkspaceModel(
              model.name(),
              model.source(),
              model.target().interfaceName(),
              model.target().method()));
    }
    methods.clear();
    addMethods(activity.provided(), false);
    addMethods(activity.required(), true);
  }

  /** What the readers let pass, however long it is, and the columns do not hold. */
  private static void requireStorable(Activity activity) {
    List<Diagnostic> problems = new ArrayList<>();
    requireLength("name", activity.profile().name(), MAX_NAME, problems);
    requireLength("description", activity.profile().description(), MAX_TEXT, problems);
    requireLength(
        "component.class", activity.profile().component().className(), MAX_CLASS, problems);
    for (InterfaceDescription description :
        Stream.concat(activity.provided().stream(), activity.required().stream()).toList()) {
      description
          .methods()
          .forEach(m -> requireLength("provided, required", signature(m), MAX_TEXT, problems));
    }
    if (!problems.isEmpty()) {
      throw new InvalidInputException(problems);
    }
  }

  private static void requireLength(
      String element, String text, int most, List<Diagnostic> problems) {
    if (text.length() > most) {
      problems.add(
          Diagnostic.error(
              "activity.yaml",
              0,
              element,
              "'%s...' has %d characters; at most %d are stored"
                  .formatted(text.substring(0, SHOWN), text.length(), most)));
    }
  }

  private static String signature(Method method) {
    return method.name() + "(" + method.signature() + ")";
  }

  private void addMethods(List<InterfaceDescription> descriptions, boolean required) {
    for (InterfaceDescription description : descriptions) {
      description
          .methods()
          .forEach(
              m -> methods.add(new WorkspaceMethod(description.name(), required, signature(m))));
    }
  }

  String id() {
    return id;
  }

  String name() {
    return name;
  }

  String description() {
    return description;
  }

  String language() {
    return language;
  }

  String componentClass() {
    return componentClass;
  }

  Instant created() {
    return created;
  }

  Instant updated() {
    return updated;
  }

  long version() {
    return version == null ? 0 : version;
  }

  List<StoredFile> files() {
    return List.copyOf(files);
  }

  List<WorkspaceModel> models() {
    return List.copyOf(models);
  }

  List<WorkspaceMethod> methods() {
    return List.copyOf(methods);
  }
}
