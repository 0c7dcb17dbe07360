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
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.model.TestModel;
import org.sitaf.server.file.StoredFile;
import org.sitaf.server.refusal.Refusal;

/**
 * One component under test on the server: the files of its activity, verified, and what they say.
 */
@Entity
class Workspace {
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

  private void addMethods(List<InterfaceDescription> descriptions, boolean required) {
    for (InterfaceDescription description : descriptions) {
      description
          .methods()
          .forEach(
              m ->
                  methods.add(
                      new WorkspaceMethod(
                          description.name(), required, m.name() + "(" + m.signature() + ")")));
    }
  }

  /**
   * Makes sure that a change is made to the state that its author saw.
   *
   * @param expected null where the author does not care
   */
  void requireVersion(@Nullable Long expected) {
    if (expected != null && expected != version()) {
      throw Refusal.outdated("activity", version());
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
