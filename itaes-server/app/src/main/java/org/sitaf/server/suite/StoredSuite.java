package org.sitaf.server.suite;

import jakarta.persistence.CollectionTable;
import jakarta.persistence.Column;
import jakarta.persistence.ElementCollection;
import jakarta.persistence.Embeddable;
import jakarta.persistence.Entity;
import jakarta.persistence.EnumType;
import jakarta.persistence.Enumerated;
import jakarta.persistence.Id;
import jakarta.persistence.JoinColumn;
import jakarta.persistence.OrderColumn;
import jakarta.persistence.Table;
import jakarta.persistence.Version;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Severity;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.server.error.RequestException;

/**
 * A suite in the database, without its document, which {@link SuiteDocuments} stores separately so
 * that lists do not load it.
 */
@Entity
@Table(name = "suite")
class StoredSuite {
  private static final int MAX_NOTES = 500;

  @Id private String id;

  @Column(name = "activity_id")
  private String activityId;

  private String model;
  private String name;
  private long seed;
  private int total;
  private int valid;
  private Instant created;

  /** Null for a new entity; this is how the persistence provider recognizes one. */
  @Version private @Nullable Long version;

  /** Changes with each document, so that the version is incremented. */
  private Instant updated;

  @ElementCollection
  @CollectionTable(name = "suite_parameter", joinColumns = @JoinColumn(name = "suite_id"))
  @OrderColumn(name = "position")
  private List<Parameter> parameters = new ArrayList<>();

  @ElementCollection
  @CollectionTable(name = "suite_note", joinColumns = @JoinColumn(name = "suite_id"))
  @OrderColumn(name = "position")
  private List<Note> notes = new ArrayList<>();

  /** A note of the generator, such as values that a type cannot represent. */
  @Embeddable
  record Note(
      @Enumerated(EnumType.STRING) Severity severity,
      String file,
      int line,
      String element,
      String message) {
    static Note of(Diagnostic diagnostic) {
      return new Note(
          diagnostic.severity(),
          cut(diagnostic.file(), 400),
          diagnostic.line(),
          cut(diagnostic.element(), 1000),
          cut(diagnostic.message(), 4000));
    }

    Diagnostic toDiagnostic() {
      return new Diagnostic(severity, file, line, element, message);
    }

    private static String cut(String text, int length) {
      return text.length() <= length ? text : text.substring(0, length - 1) + "…";
    }
  }

  /** A parameter of the cases. */
  @Embeddable
  record Parameter(String name, @Enumerated(EnumType.STRING) InputKind kind, String realType) {
    static Parameter of(CaseParameter parameter) {
      return new Parameter(parameter.name(), parameter.kind(), parameter.realType());
    }

    CaseParameter toCaseParameter() {
      return new CaseParameter(name, kind, realType);
    }
  }

  /** For the persistence provider. */
  protected StoredSuite() {
    id = "";
    activityId = "";
    model = "";
    name = "";
    created = Instant.EPOCH;
    updated = Instant.EPOCH;
  }

  StoredSuite(String id, String activityId, TestSuite suite, List<Diagnostic> notes, Instant now) {
    this();
    notes.stream().limit(MAX_NOTES).map(Note::of).forEach(this.notes::add);
    this.id = id;
    this.activityId = activityId;
    this.created = now;
    model = suite.modelName();
    replace(suite, now);
  }

  /** Replaces the suite with an edited one of the same model. */
  final void replace(TestSuite suite, Instant now) {
    if (!suite.modelName().equals(model)) {
      throw RequestException.conflict(
          "The document belongs to model '"
              + suite.modelName()
              + "', but the suite to '"
              + model
              + "'.");
    }
    name = suite.name();
    seed = suite.generation().seed();
    total = suite.cases().size();
    valid = Math.toIntExact(suite.validCount());
    updated = now;
    List<Parameter> newParameters = suite.parameters().stream().map(Parameter::of).toList();
    if (!parameters.equals(newParameters)) {
      parameters.clear();
      parameters.addAll(newParameters);
    }
  }

  String id() {
    return id;
  }

  String activityId() {
    return activityId;
  }

  String model() {
    return model;
  }

  String name() {
    return name;
  }

  long seed() {
    return seed;
  }

  int total() {
    return total;
  }

  int valid() {
    return valid;
  }

  Instant created() {
    return created;
  }

  long version() {
    return version == null ? 0 : version;
  }

  List<Diagnostic> notes() {
    return notes.stream().map(Note::toDiagnostic).toList();
  }

  List<CaseParameter> parameters() {
    return parameters.stream().map(Parameter::toCaseParameter).toList();
  }
}
