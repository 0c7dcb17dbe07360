package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.Definition;
import org.sitaf.schemas.ConditionType;
import org.sitaf.schemas.DefineType;

/** Reads definitions, pre-conditions and post-conditions. */
final class ConditionReader {
  static final String PRE_CONDITION = "pre_condition";
  static final String POST_CONDITION = "post_condition";

  static final String DEFINE = "define";

  private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]{0,99}");

  private final Problems problems;
  private final ElementLines lines;

  /**
   * @param lines of conditions
   */
  ConditionReader(Problems problems, ElementLines lines) {
    this.problems = problems;
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
        String name = text(conditions.get(i).getName());
        int line = lines.of(element, i);
        if (!name.isEmpty() && element.equals(PRE_CONDITION)) {
          problems.error(line, element, "a name has no effect here, only on a post_condition");
        }
        found.add(new Condition(name, expression.strip(), line));
      }
    }
    return found;
  }

  /** Reads the definitions. A name that is missing, invalid or used twice is reported. */
  List<Definition> definitions(List<DefineType> definitions) {
    List<Definition> found = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (int i = 0; i < definitions.size(); i++) {
      String name = text(definitions.get(i).getName());
      String expression = text(definitions.get(i).getValue());
      int line = lines.of(DEFINE, i);
      String where = "define " + name;
      if (!NAME.matcher(name).matches()) {
        problems.error(line, where, "needs a name of letters, digits and '_', not '" + name + "'");
      } else if (!names.add(name)) {
        problems.error(line, where, "another definition has this name");
      } else if (expression.isEmpty()) {
        problems.error(line, where, "has no expression");
      } else {
        found.add(new Definition(name, expression, line));
      }
    }
    return found;
  }
}
