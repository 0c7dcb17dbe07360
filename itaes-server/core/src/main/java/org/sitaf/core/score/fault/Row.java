package org.sitaf.core.score.fault;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A case to which faults are applied: a case of the suite, a second run of a relation, or a case
 * beyond the suite that shows whether a fault has any effect.
 *
 * @param values literals in the order of the model's inputs
 * @param before the values of the case before in the suite; null if there is none
 */
public record Row(List<String> values, @Nullable List<String> before) {
  public Row {
    values = List.copyOf(values);
    before = before == null ? null : List.copyOf(before);
  }
}
