package org.sitaf.server.activity;

import jakarta.persistence.CollectionTable;
import jakarta.persistence.Column;
import jakarta.persistence.ElementCollection;
import jakarta.persistence.Entity;
import jakarta.persistence.Id;
import jakarta.persistence.JoinColumn;
import jakarta.persistence.OrderBy;
import jakarta.persistence.OrderColumn;
import jakarta.persistence.Table;
import jakarta.persistence.Version;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import org.hibernate.annotations.OptimisticLock;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.server.file.StoredFile;

/** An activity in the database: its files, and what lists and searches need of them. */
@Entity
@Table(name = "activity")
class StoredActivity {
  private static final int MAX_NAME = 200;
  private static final int MAX_CLASS = 1000;
  private static final int MAX_TEXT = 4000;
  private static final int MAX_SHOWN = 60;

  @Id private String id;
  private String name;
  private String description;
  private String language;
  private String componentClass;
  private Instant created;
  private Instant updated;

  /** Null for a new entity; this is how the persistence provider recognizes one. */
  @Version private @Nullable Long version;

  @ElementCollection
  @CollectionTable(name = "activity_file", joinColumns = @JoinColumn(name = "activity_id"))
  @OrderBy("path")
  private Set<StoredFile> files = new LinkedHashSet<>();

  @ElementCollection
  @CollectionTable(name = "activity_model", joinColumns = @JoinColumn(name = "activity_id"))
  @OrderColumn(name = "position")
  private List<StoredModel> models = new ArrayList<>();

  @ElementCollection
  @CollectionTable(name = "activity_method", joinColumns = @JoinColumn(name = "activity_id"))
  @OrderColumn(name = "position")
  private List<StoredMethod> methods = new ArrayList<>();

  /** Not part of the version, which is that of the files. */
  @ElementCollection
  @CollectionTable(name = "activity_tag", joinColumns = @JoinColumn(name = "activity_id"))
  @Column(name = "name")
  @OptimisticLock(excluded = true)
  private Set<String> tags = new LinkedHashSet<>();

  /** For the persistence provider. */
  @SuppressWarnings("NullAway")
  protected StoredActivity() {
    id = "";
    name = "";
    description = "";
    language = "";
    componentClass = "";
    created = Instant.EPOCH;
    updated = Instant.EPOCH;
  }

  /** Creates the entity of a verified activity whose file contents are stored. */
  StoredActivity(String id, Activity activity, List<StoredFile> files, Instant now) {
    this();
    this.id = id;
    this.created = now;
    replace(activity, files, now);
  }

  /** Replaces the activity. */
  final void replace(Activity activity, List<StoredFile> newFiles, Instant now) {
    requireStorable(activity);
    name = activity.profile().name();
    description = activity.profile().description();
    language = activity.profile().component().language().id();
    componentClass = activity.profile().component().className();
    updated = now;
    files.removeIf(old -> !newFiles.contains(old));
    files.addAll(newFiles);
    models.clear();
    for (TestModel model : activity.models()) {
      models.add(
          new StoredModel(
              model.name(),
              model.source(),
              model.target().interfaceName(),
              model.target().method()));
    }
    methods.clear();
    addMethods(activity.provided(), false);
    addMethods(activity.required(), true);
  }

  /** Replaces the tags. */
  void tag(Set<String> names) {
    tags.retainAll(names);
    tags.addAll(names);
  }

  /** Reports texts that are too long for their columns. */
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
      String element, String text, int maxLength, List<Diagnostic> problems) {
    if (text.length() > maxLength) {
      problems.add(
          Diagnostic.error(
              "activity.yaml",
              0,
              element,
              "'%s...' has %d characters; the maximum is %d"
                  .formatted(text.substring(0, MAX_SHOWN), text.length(), maxLength)));
    }
  }

  private static String signature(Method method) {
    return method.name() + "(" + method.signature() + ")";
  }

  private void addMethods(List<InterfaceDescription> descriptions, boolean required) {
    for (InterfaceDescription description : descriptions) {
      description
          .methods()
          .forEach(m -> methods.add(new StoredMethod(description.name(), required, signature(m))));
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

  List<StoredModel> models() {
    return List.copyOf(models);
  }

  List<StoredMethod> methods() {
    return List.copyOf(methods);
  }

  /** In ascending order. */
  List<String> tags() {
    return tags.stream().sorted().toList();
  }
}
