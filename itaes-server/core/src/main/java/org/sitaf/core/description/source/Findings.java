package org.sitaf.core.description.source;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.Severity;

/** Collects the results of the importers. */
public final class Findings {
  private static final Pattern IDENTIFIER = Pattern.compile("[A-Za-z_][A-Za-z0-9_]{0,199}");

  private final List<ComponentDescription> components = new ArrayList<>();
  private final List<InterfaceDescription> provided = new ArrayList<>();
  private final List<InterfaceDescription> required = new ArrayList<>();
  private final List<DataType> types = new ArrayList<>();
  private final Map<String, Object> constants = new TreeMap<>();
  private final Diagnostics diagnostics = new Diagnostics();

  /** Adds a component. */
  public void component(ComponentDescription component) {
    components.add(component);
  }

  /** Adds a provided interface. */
  public void provides(InterfaceDescription description) {
    provided.add(description);
  }

  /** Adds a required interface. */
  public void requires(InterfaceDescription description) {
    required.add(description);
  }

  /** Adds a declared struct or enumeration. */
  public void type(DataType type) {
    types.add(type);
  }

  /**
   * Adds a declared constant. The first of several declarations is used.
   *
   * @param name with dots, such as {@code Spin_Result.TIMEOUT}
   * @param value Long, Double, Boolean or String
   */
  public void constant(String name, Object value) {
    constants.putIfAbsent(name, value);
  }

  /** Reports an error. */
  public void error(Place place, String message) {
    diagnostics.error(place.file(), place.line(), place.element(), message);
  }

  /** Reports a warning. */
  public void warning(Place place, String message) {
    diagnostics.warning(place.file(), place.line(), place.element(), message);
  }

  /** Adds diagnostics that were collected elsewhere. */
  public void addAll(List<Diagnostic> others) {
    diagnostics.addAll(others);
  }

  /**
   * Reports that a file that was not requested could not be read. This is only a warning, which
   * explains why types of this file are unknown.
   */
  public void warnUnreadable(List<Diagnostic> others) {
    others.stream()
        .filter(d -> d.severity() == Severity.ERROR)
        .limit(1)
        .forEach(
            d ->
                diagnostics.warning(
                    d.file(),
                    d.line(),
                    d.element(),
                    "could not be read, its types are unknown: " + d.message()));
  }

  /**
   * Checks that a name is an identifier, because it may be used in generated source code.
   *
   * @return the name, or {@code unnamed} after reporting an invalid name
   */
  public String identifier(@org.jspecify.annotations.Nullable String name, Place place) {
    if (name == null || !IDENTIFIER.matcher(name).matches()) {
      String shown = name != null && name.length() > 60 ? name.substring(0, 60) + "..." : name;
      error(
          place,
          (shown == null ? "has no name" : "'" + shown + "' is not a name")
              + "; use letters, digits and '_', not beginning with a digit, at most 200"
              + " characters");
      return "unnamed";
    }
    return name;
  }

  /** Checks that prototypes and parameter names are unique. */
  public void checkDistinct(InterfaceDescription description) {
    Set<String> prototypes = new HashSet<>();
    for (Method method : description.methods()) {
      Place place = new Place(description.source(), method.line(), "method " + method.name());
      if (!prototypes.add(method.name() + "(" + method.signature() + ")")) {
        error(place, "is declared twice with the same parameter types; remove one");
      }
      Set<String> names = new HashSet<>();
      for (Parameter parameter : method.parameters()) {
        if (!names.add(parameter.name())) {
          error(
              new Place(place.file(), place.line(), place.element() + "/param " + parameter.name()),
              "two parameters have this name");
        }
      }
    }
  }

  /** Reports the use of an undefined type. */
  public void unknownType(Place place, String name, String reason) {
    warning(
        place,
        reason.isEmpty()
            ? "unknown type '" + name + "'"
            : "type '" + name + "' is not supported: " + reason);
  }

  /** What was found until now. */
  public ImportResult result() {
    return new ImportResult(
        components,
        provided.stream().map(i -> i.withConstants(constants)).toList(),
        required.stream().map(i -> i.withConstants(constants)).toList(),
        types,
        constants,
        diagnostics.all());
  }
}
