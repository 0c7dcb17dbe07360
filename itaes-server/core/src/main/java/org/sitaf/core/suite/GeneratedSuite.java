package org.sitaf.core.suite;

import java.util.List;
import java.util.Objects;
import org.sitaf.core.diagnostic.Diagnostic;

/**
 * A suite, and what its reader should know of its making.
 *
 * @param notes values that a type cannot hold, combinations that no allowed case can hold, expected
 *     values that have no value
 */
public record GeneratedSuite(TestSuite suite, List<Diagnostic> notes) {
  public GeneratedSuite {
    Objects.requireNonNull(suite);
    notes = List.copyOf(notes);
  }
}
