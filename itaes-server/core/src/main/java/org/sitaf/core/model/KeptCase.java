package org.sitaf.core.model;

import java.util.List;

/**
 * A test case that the user wants to keep.
 *
 * @param no case number, from 1; 0 if not numbered yet
 * @param values one value per input element, in order
 * @param line line in the document, from 1; 0 if unknown
 */
public record KeptCase(int no, List<Value> values, int line) {
  public KeptCase {
    values = List.copyOf(values);
  }
}
