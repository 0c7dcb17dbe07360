package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.NearestName;
import org.sitaf.core.document.ElementLines;
import org.sitaf.core.document.XmlDocuments;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.Relation;
import org.sitaf.schemas.RelationChangeType;
import org.sitaf.schemas.RelationType;
import org.sitaf.schemas.TestModelDocument.RelationList;

/** Reads relations between two runs. */
final class RelationReader {
  /** The element of a relation's condition. */
  static final String HOLDS = "holds";

  private static final int MAX_NAME = 100;

  /** Maximum number of relations in a model, since each one executes all valid cases. */
  private static final int MAX_RELATIONS = 20;

  private final Problems problems;
  private final ElementLines lines;
  private final Set<String> inputs;
  private int conditions;

  /**
   * @param lines of conditions
   * @param inputs of the model
   */
  RelationReader(Problems problems, ElementLines lines, List<InputElement> inputs) {
    this.problems = problems;
    this.lines = lines;
    this.inputs = inputs.stream().map(InputElement::name).collect(Collectors.toSet());
  }

  List<Relation> read(@Nullable RelationList list) {
    List<RelationType> given = list == null ? List.of() : list.getRelation();
    if (list != null && given.size() > MAX_RELATIONS) {
      problems.error(
          XmlDocuments.line(list),
          "relation_list",
          "has " + given.size() + " relations, but at most " + MAX_RELATIONS + " are allowed");
    }
    List<Relation> found = new ArrayList<>();
    Set<String> names = new HashSet<>();
    for (RelationType relation : given) {
      int line = XmlDocuments.line(relation);
      String name = Problems.text(relation.getName());
      if (name.isEmpty() || name.length() > MAX_NAME) {
        problems.error(line, "relation", "needs a name of at most " + MAX_NAME + " characters");
      } else if (!names.add(name)) {
        problems.error(line, "relation " + name, "another relation has this name");
      }
      found.add(read(relation, name, line));
    }
    int further = lines.of(HOLDS, conditions);
    if (further > 0) {
      problems.error(
          further, "relation/holds", "a relation has one holds; combine conditions with &&");
    }
    return found;
  }

  private Relation read(RelationType given, String name, int line) {
    String where = "relation " + name;
    List<Relation.Change> changes = new ArrayList<>();
    Set<String> changed = new HashSet<>();
    for (RelationChangeType change : given.getChange()) {
      int changeLine = XmlDocuments.line(change);
      String input = Problems.text(change.getName());
      String expression = Problems.text(change.getValue());
      if (!inputs.contains(input)) {
        problems.error(
            changeLine,
            where + "/change",
            (input.isEmpty()
                    ? "needs the name of an input"
                    : "'" + input + "' is not an input" + NearestName.hint(input, inputs))
                + " Inputs: "
                + inputs.stream().sorted().collect(Collectors.joining(", ")));
      } else if (!changed.add(input)) {
        problems.error(changeLine, where + "/change", "another change sets " + input);
      } else if (expression.isEmpty()) {
        problems.error(
            changeLine, where + "/change", "is empty; write an expression such as 2.0 * " + input);
      } else {
        changes.add(new Relation.Change(input, expression, changeLine));
      }
    }
    if (given.getChange().isEmpty()) {
      problems.error(line, where, "needs a change, such as <change name=\"x\">-x</change>");
    }
    String holds = Problems.text(given.getHolds());
    int holdsLine = given.getHolds() == null ? line : lines.of(HOLDS, conditions++);
    if (holds.isEmpty()) {
      problems.error(
          holdsLine,
          where,
          "needs a condition, such as <holds>after.value == before.value</holds>");
    }
    return new Relation(name, changes, holds, line, holdsLine);
  }
}
