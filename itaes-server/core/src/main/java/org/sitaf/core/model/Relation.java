package org.sitaf.core.model;

import java.util.List;
import java.util.Objects;

/**
 * A relation between two runs of a valid case (a metamorphic relation): the second run has changed
 * inputs, and a condition compares the outputs of both.
 *
 * @param changes of the inputs; other inputs keep their values
 * @param holds the condition
 * @param line line in the model, from 1; 0 if unknown
 * @param holdsLine line of the condition
 */
public record Relation(String name, List<Change> changes, String holds, int line, int holdsLine) {
  public Relation {
    Objects.requireNonNull(name);
    changes = List.copyOf(changes);
    Objects.requireNonNull(holds);
  }

  /**
   * The value of an input in the second run.
   *
   * @param input name of the input
   * @param expression over the inputs of the first run
   * @param line line in the model, from 1; 0 if unknown
   */
  public record Change(String input, String expression, int line) {
    public Change {
      Objects.requireNonNull(input);
      Objects.requireNonNull(expression);
    }
  }
}
