package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.TrajectoryCondition;
import org.sitaf.schemas.TestModelDocument.TrajectoryConditionSpecList;
import org.sitaf.schemas.TrajectoryConditionType;

/** Reads conditions over time. */
final class TrajectoryConditionReader {
  private static final int MAX_NAME = 100;

  private final Problems problems;

  TrajectoryConditionReader(Problems problems) {
    this.problems = problems;
  }

  List<TrajectoryCondition> read(@Nullable TrajectoryConditionSpecList list) {
    List<TrajectoryCondition> found = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (TrajectoryConditionType given :
        list == null ? List.<TrajectoryConditionType>of() : list.getTrajectoryCondition()) {
      int line = XmlDocuments.line(given);
      String name = Problems.text(given.getName());
      String where = "trajectory_condition " + name;
      if (name.isEmpty() || name.length() > MAX_NAME) {
        problems.error(
            line, "trajectory_condition", "needs a name of at most " + MAX_NAME + " characters");
      } else if (!names.add(name)) {
        problems.error(line, where, "another trajectory_condition has this name");
      }
      String from = given.getFrom() == null ? "call" : given.getFrom();
      if (!from.equals("call") && !from.equals("settle")) {
        problems.error(line, where, "from must be call or settle, not '" + from + "'");
      }
      String formula = Problems.text(given.getValue());
      if (formula.isEmpty()) {
        problems.error(line, where, "is empty; write a formula, such as always(x < 1.0)");
      }
      found.add(
          new TrajectoryCondition(
              name, from.equals("settle"), formula, line + linesBefore(given.getValue())));
    }
    return found;
  }

  /** The number of lines between the element and its formula. */
  private static int linesBefore(@Nullable String text) {
    String given = text == null ? "" : text;
    return (int) given.chars().takeWhile(Character::isWhitespace).filter(c -> c == '\n').count();
  }
}
