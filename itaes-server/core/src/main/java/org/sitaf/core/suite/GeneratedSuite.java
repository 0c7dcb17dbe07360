package org.sitaf.core.suite;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.diagnostic.Diagnostic;

/**
 * A generated suite with warnings.
 *
 * @param notes skipped values, impossible combinations, and expected values that could not be
 *     computed
 */
public record GeneratedSuite(TestSuite suite, List<Diagnostic> notes) {
  public GeneratedSuite {
    Objects.requireNonNull(suite);
    notes = List.copyOf(notes);
  }
}
