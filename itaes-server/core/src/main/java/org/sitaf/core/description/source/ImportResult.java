package org.sitaf.core.description.source;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.diagnostic.Severity;

/**
 * The result of importing interface files.
 *
 * @param components component profiles
 * @param provided interfaces that a component provides, or that no component references
 * @param required interfaces that a component requires
 * @param types declared structs and enumerations
 * @param constants values of the declared constants by their name with dots
 * @param diagnostics errors and warnings; parts with errors may be missing from the other lists
 */
public record ImportResult(
    List<ComponentDescription> components,
    List<InterfaceDescription> provided,
    List<InterfaceDescription> required,
    List<DataType> types,
    Map<String, Object> constants,
    List<Diagnostic> diagnostics) {
  public ImportResult {
    components = List.copyOf(components);
    provided = List.copyOf(provided);
    required = List.copyOf(required);
    types = List.copyOf(types);
    constants = Collections.unmodifiableMap(new TreeMap<>(constants));
    diagnostics = List.copyOf(diagnostics);
  }

  /** Whether there is at least one error. */
  public boolean hasErrors() {
    return diagnostics.stream().anyMatch(d -> d.severity() == Severity.ERROR);
  }

  /**
   * Returns this result if it has no errors.
   *
   * @throws InvalidInputException with all diagnostics, if one of them is an error
   */
  public ImportResult orThrow() {
    if (hasErrors()) {
      throw new InvalidInputException(diagnostics);
    }
    return this;
  }
}
