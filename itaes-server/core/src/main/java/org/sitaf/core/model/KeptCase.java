package org.sitaf.core.model;

import java.util.List;

/**
 * A case that the user wants to keep.
 *
 * @param no its number, from 1; 0 where it has none yet
 * @param values one for each input element, in their order
 * @param line where it stands in its document, from 1; 0 where that is unknown
 */
public record KeptCase(int no, List<Value> values, int line) {
  public KeptCase {
    values = List.copyOf(values);
  }
}
