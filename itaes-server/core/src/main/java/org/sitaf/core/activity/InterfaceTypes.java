package org.sitaf.core.activity;

import java.util.List;
import java.util.Optional;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;

/**
 * Gives a model what only the interfaces know: the literals of the enumerations that its elements
 * are of.
 */
final class InterfaceTypes {
  private InterfaceTypes() {}

  /**
   * The model with its elements' enumerations resolved; as it was where its target is not found.
   */
  static TestModel resolve(TestModel model, List<InterfaceDescription> provided) {
    Method method;
    try {
      method = TargetMethod.find(model, provided).method();
    } catch (IllegalArgumentException e) {
      // Told where the model is verified against the activity.
      return model;
    }
    return model.withInputs(model.inputs().stream().map(input -> resolve(input, method)).toList());
  }

  private static InputElement resolve(InputElement input, Method method) {
    Optional<DataType> type =
        input.kind() == InputKind.TDI
            ? method.parameters().stream()
                .filter(p -> p.name().equals(MemberPath.root(input.name())))
                .findFirst()
                .map(Parameter::type)
                .flatMap(t -> MemberPath.resolve(t, input.name()))
            : Optional.empty();
    return type.filter(DataType.Enumeration.class::isInstance).map(input::withType).orElse(input);
  }
}
