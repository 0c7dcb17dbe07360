package org.sitaf.core.suite;

import java.util.List;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.value.TestValue;

/** The variables of a case before the call: the inputs, and which of them are valid. */
public final class CaseVariables {
  private CaseVariables() {}

  /**
   * @param row one value for each input of the model
   */
  public static Variables of(TestModel model, List<TestValue> row) {
    Variables variables = new Variables();
    for (int i = 0; i < row.size(); i++) {
      variables.putValidity(model.inputs().get(i).name(), row.get(i).valid());
    }
    variables.put(Variables.VALID, row.stream().allMatch(TestValue::valid));
    // Last, because an input hides other names.
    for (int i = 0; i < row.size(); i++) {
      InputElement input = model.inputs().get(i);
      variables.put(input.name(), row.get(i).value(), input.type());
    }
    return variables;
  }
}
