package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sitaf.core.activity.TargetMethod;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.MemberPath.Step;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan.Argument;
import org.sitaf.core.harness.plan.HarnessPlan.Given;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestSuite;

/** Plans the arguments of the method under test. */
final class ArgumentPlanner {
  /**
   * Maximum index of an element that is set individually, so a name such as {@code path[999999]}
   * cannot exhaust the memory of a test.
   */
  private static final int MAX_INDEX = 255;

  private final TargetMethod target;
  private final TestModel model;
  private final TestSuite suite;
  private final Diagnostics diagnostics;

  ArgumentPlanner(TargetMethod target, TestModel model, TestSuite suite, Diagnostics diagnostics) {
    this.target = target;
    this.model = model;
    this.suite = suite;
    this.diagnostics = diagnostics;
  }

  List<Argument> plan() {
    Method method = target.method();
    if (!Words.isWord(method.name())) {
      inMethod("is not a valid method name");
    }
    List<Argument> arguments = new ArrayList<>();
    for (Parameter parameter : method.parameters()) {
      if (!Words.isWord(parameter.name())) {
        inMethod("parameter '" + parameter.name() + "' is not an identifier");
        continue;
      }
      List<Given> given = given(parameter);
      if (given.isEmpty() && parameter.direction() == Direction.IN) {
        diagnostics.error(
            model.source(),
            0,
            "input_spec_list",
            "the test cases have no value for parameter "
                + parameter.name()
                + " of "
                + method.name()
                + "; add a test_element of type TDI");
      }
      overlaps(given);
      arguments.add(new Argument(parameter, given));
    }
    checkTargets();
    return arguments;
  }

  private List<Given> given(Parameter parameter) {
    List<Given> given = new ArrayList<>();
    for (CaseParameter column : suite.parameters()) {
      if (column.kind() != InputKind.TDI
          || !MemberPath.root(column.name()).equals(parameter.name())
          || parameter.direction() == Direction.OUT) {
        continue;
      }
      Optional<DataType> type = MemberPath.resolve(parameter.type(), column.name());
      if (type.isEmpty()) {
        inModel(column, parameter.type().typeName() + " has no such member or element");
        continue;
      }
      List<Step> path = MemberPath.steps(column.name());
      if (path.stream().anyMatch(s -> s instanceof Step.Element e && e.index() > MAX_INDEX)) {
        inModel(column, "sets an element with an index greater than " + MAX_INDEX);
        continue;
      }
      given.add(new Given(column.name(), path, type.get()));
    }
    return given;
  }

  /** Overlapping values are an error: their order must not matter. */
  private void overlaps(List<Given> given) {
    for (Given outer : given) {
      for (Given inner : given) {
        int depth = outer.path().size();
        if (inner != outer
            && inner.path().size() >= depth
            && inner.path().subList(0, depth).equals(outer.path())) {
          diagnostics.error(
              model.source(),
              0,
              "test_element " + inner.column(),
              "is a part of " + outer.column() + ", which is also set; remove one of them");
        }
      }
    }
  }

  /** Checks that every value is passed to a parameter. */
  private void checkTargets() {
    for (CaseParameter column : suite.parameters()) {
      if (column.kind() == InputKind.TDI
          && target.method().parameters().stream()
              .noneMatch(
                  p ->
                      p.name().equals(MemberPath.root(column.name()))
                          && p.direction() != Direction.OUT)) {
        inModel(column, target.method().name() + " has no such input parameter");
      }
    }
  }

  private void inMethod(String problem) {
    Method method = target.method();
    diagnostics.error(
        target.declaring().source(), method.line(), "method " + method.name(), problem);
  }

  private void inModel(CaseParameter column, String problem) {
    diagnostics.error(model.source(), 0, "test_element " + column.name(), problem);
  }
}
