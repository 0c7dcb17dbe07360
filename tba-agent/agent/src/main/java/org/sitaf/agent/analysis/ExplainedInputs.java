package org.sitaf.agent.analysis;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.build.AnalysisReport;
import org.sitaf.core.description.DataType;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.InputValidity;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/** The inputs of a model with the values of a suite, as an explanation shows them. */
final class ExplainedInputs {
  private static final int MAX_VALUES = 100;

  private ExplainedInputs() {}

  static List<AnalysisReport.Input> of(TestModel model, TestSuite suite) {
    InputValidity validity = new InputValidity(model, suite.generation().seed());
    List<AnalysisReport.Input> inputs = new ArrayList<>();
    for (int i = 0; i < model.inputs().size(); i++) {
      InputElement input = model.inputs().get(i);
      Map<String, Boolean> values = new LinkedHashMap<>();
      for (TestCase each : suite.cases()) {
        String literal = each.values().get(i);
        if (values.size() < MAX_VALUES && !values.containsKey(literal)) {
          values.put(literal, validity.isValid(i, literal));
        }
      }
      boolean numeric = input.type() instanceof DataType.Scalar scalar && scalar.type().isNumeric();
      inputs.add(new AnalysisReport.Input(input.name(), numeric, values));
    }
    return inputs;
  }
}
