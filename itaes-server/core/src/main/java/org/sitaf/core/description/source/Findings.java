package org.sitaf.core.description.source;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.Severity;

/** Collects what the importers find. */
public final class Findings {
  private static final Pattern IDENTIFIER = Pattern.compile("[A-Za-z_][A-Za-z0-9_]{0,199}");

  private final List<ComponentDescription> components = new ArrayList<>();
  private final List<InterfaceDescription> provided = new ArrayList<>();
  private final List<InterfaceDescription> required = new ArrayList<>();
  private final List<DataType> types = new ArrayList<>();
  private final Diagnostics diagnostics = new Diagnostics();

  /** Adds a component. */
  public void component(ComponentDescription component) {
    components.add(component);
  }

  /** Adds an interface that is offered. */
  public void provides(InterfaceDescription description) {
    provided.add(description);
  }

  /** Adds an interface that is called. */
  public void requires(InterfaceDescription description) {
    required.add(description);
  }

  /** Adds a struct or an enumeration that the files declare. */
  public void type(DataType type) {
    types.add(type);
  }

  /** Reports what makes an input unusable. */
  public void error(Place place, String message) {
    diagnostics.error(place.file(), place.line(), place.element(), message);
  }

  /** Reports what was left out or is probably a mistake. */
  public void warning(Place place, String message) {
    diagnostics.warning(place.file(), place.line(), place.element(), message);
  }

  /** Reports what another reading collected. */
  public void addAll(List<Diagnostic> others) {
    diagnostics.addAll(others);
  }

  /**
   * Reports what is wrong with a file that was not asked for: there it is no error, but explains
   * why its types are unknown.
   */
  public void aside(List<Diagnostic> others) {
    others.stream()
        .filter(d -> d.severity() == Severity.ERROR)
        .limit(1)
        .forEach(
            d ->
                diagnostics.warning(
                    d.file(),
                    d.line(),
                    d.element(),
                    "not read, so that its types are unknown: " + d.message()));
  }

  /**
   * Checks a name, which may reach generated source code.
   *
   * @return the name, or {@code unnamed} where it is none, which is reported
   */
  public String identifier(@org.jspecify.annotations.Nullable String name, Place place) {
    if (name == null || !IDENTIFIER.matcher(name).matches()) {
      String shown = name != null && name.length() > 60 ? name.substring(0, 60) + "..." : name;
      error(
          place,
          (shown == null ? "has no name" : "'" + shown + "' is not a name")
              + "; letters, digits and '_', not beginning with a digit, at most 200");
      return "unnamed";
    }
    return name;
  }

  /** Checks that no two methods of an interface, and no two parameters of one, are the same. */
  public void checkDistinct(InterfaceDescription description) {
    Set<String> prototypes = new HashSet<>();
    for (Method method : description.methods()) {
      Place place = new Place(description.source(), method.line(), "method " + method.name());
      if (!prototypes.add(method.name() + "(" + method.signature() + ")")) {
        error(place, "stands here twice with the same parameter types; remove one");
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

  /** Says of a type that nothing defines where it is used. */
  public void unknownType(Place place, String name, String reason) {
    warning(
        place,
        (reason.isEmpty() ? "unknown type '" + name + "'" : "type '" + name + "' is " + reason)
            + ", kept by its name");
  }

  /** What was found until now. */
  public Described described() {
    return new Described(components, provided, required, types, diagnostics.all());
  }
}
