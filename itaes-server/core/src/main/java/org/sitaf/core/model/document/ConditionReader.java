package org.sitaf.core.model.document;

import static org.sitaf.core.model.document.Problems.text;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.Condition;
import org.sitaf.core.model.Definition;
import org.sitaf.schemas.ConditionType;
import org.sitaf.schemas.DefineType;

/** Reads definitions, pre-conditions and post-conditions. */
final class ConditionReader {
  static final String PRE_CONDITION = "pre_condition";
  static final String POST_CONDITION = "post_condition";

  static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]{0,99}");

  private final Problems problems;

  ConditionReader(Problems problems) {
    this.problems = problems;
  }

  /**
   * Reads the conditions of one list. Empty ones are left out.
   *
   * @param element name of the conditions' element
   */
  List<Condition> read(String element, List<ConditionType> conditions) {
    List<Condition> found = new ArrayList<>();
    for (ConditionType condition : conditions) {
      String expression = condition.getValue();
      if (expression != null && !expression.isBlank()) {
        String name = text(condition.getName());
        int line = XmlDocuments.line(condition);
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
    for (DefineType definition : definitions) {
      String name = text(definition.getName());
      String expression = text(definition.getValue());
      int line = XmlDocuments.line(definition);
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
