package org.sitaf.core.description.source;

import java.util.List;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.diagnostic.Severity;

/**
 * What interface files say.
 *
 * @param components component profiles among them
 * @param provided interfaces that a component offers, and those that no component claims
 * @param required interfaces that a component calls
 * @param types structs and enumerations that the files declare
 * @param diagnostics errors and warnings; what an error concerns may be missing above
 */
public record Described(
    List<ComponentDescription> components,
    List<InterfaceDescription> provided,
    List<InterfaceDescription> required,
    List<DataType> types,
    List<Diagnostic> diagnostics) {
  public Described {
    components = List.copyOf(components);
    provided = List.copyOf(provided);
    required = List.copyOf(required);
    types = List.copyOf(types);
    diagnostics = List.copyOf(diagnostics);
  }

  /** Whether a file cannot be used. */
  public boolean hasErrors() {
    return diagnostics.stream().anyMatch(d -> d.severity() == Severity.ERROR);
  }

  /**
   * This, where nothing is wrong with it.
   *
   * @throws InvalidInputException with every diagnostic, where one of them is an error
   */
  public Described orThrow() {
    if (hasErrors()) {
      throw new InvalidInputException(diagnostics);
    }
    return this;
  }
}
