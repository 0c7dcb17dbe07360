package org.sitaf.core.verdict;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.verdict.CaseRecord.Outcome;

/**
 * The variable {@code steps} of a model's own post-conditions: a list of maps of name, inputs,
 * outputs, error and time.
 */
final class StepMaps {
  /** The return value, whose own name is a reserved word in CEL. */
  private static final String VALUE = "value";

  private final Map<String, TestModel> models;

  /**
   * Creates the maps of a sequence.
   *
   * @param models the models of the calls by name
   */
  StepMaps(Map<String, TestModel> models) {
    this.models = models;
  }

  /** The executed steps of a case. */
  List<Object> of(TestCase testCase, CaseRecord record) {
    List<Object> maps = new ArrayList<>();
    for (int i = 0; i < Math.min(testCase.steps().size(), record.steps().size()); i++) {
      maps.add(of(testCase.steps().get(i), record.steps().get(i)));
    }
    return maps;
  }

  private Map<String, Object> of(TestStep step, StepRecord ended) {
    TestModel model = models.get(step.name());
    Map<String, Object> map = new HashMap<>();
    map.put("name", step.name());
    map.put("inputs", model == null ? Map.of() : inputs(model, step));
    map.put("outputs", model == null ? Map.of() : outputs(model, ended.record()));
    map.put(
        Variables.ERROR, ended.record().outcome() == Outcome.THREW ? ended.record().thrown() : "");
    map.put("time", ended.atNanos() / 1e9);
    return map;
  }

  private static Map<String, Object> inputs(TestModel model, TestStep step) {
    Variables variables = new Variables();
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      variables.put(input.name(), step.values().get(i), input.type());
    }
    return variables.map();
  }

  private static Map<String, Object> outputs(TestModel model, CaseRecord record) {
    Variables variables = new Variables();
    Set<String> present = variables.map().keySet();
    for (NamedValue actual : record.actual()) {
      String root = MemberPath.root(actual.output());
      boolean isPart = !root.equals(actual.output());
      if (isPart && present.contains(root)) {
        continue;
      }
      DataType type =
          model.output(actual.output()).map(OutputElement::type).orElse(new DataType.Unknown(""));
      variables.put(actual.output(), actual.literal(), type);
      if (root.equals(OutputElement.RETURN_NAME)) {
        String part = actual.output().substring(OutputElement.RETURN_NAME.length());
        variables.put(VALUE + part, actual.literal(), type);
      }
    }
    return variables.map();
  }
}
