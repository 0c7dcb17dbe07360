package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.model.Condition;
import org.sitaf.schemas.ConditionType;

/** Reads pre-conditions and post-conditions. */
final class ConditionReader {
  static final String PRE_CONDITION = "pre_condition";
  static final String POST_CONDITION = "post_condition";

  private final ElementLines lines;

  /**
   * @param lines of conditions
   */
  ConditionReader(ElementLines lines) {
    this.lines = lines;
  }

  /**
   * Reads the conditions of one list. Empty ones are left out.
   *
   * @param element name of the conditions' element
   */
  List<Condition> read(String element, List<ConditionType> conditions) {
    List<Condition> found = new ArrayList<>();
    for (int i = 0; i < conditions.size(); i++) {
      String expression = conditions.get(i).getValue();
      if (expression != null && !expression.isBlank()) {
        found.add(new Condition(expression.strip(), lines.of(element, i)));
      }
    }
    return found;
  }
}
