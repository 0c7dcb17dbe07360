package org.sitaf.core.activity;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceSpec;

/**
 * Resolves the types of a model's elements that only the interfaces define: enumerations and
 * structs.
 */
final class InterfaceTypes {
  private static final Pattern STUB_NAME =
      Pattern.compile("([^.#]+)\\.([^.#]+)(?:\\.([^.#]+))?(?:#\\d+)?");

  private final List<InterfaceDescription> required;
  private final List<Port.Data> outputPorts;
  private final Method method;

  private InterfaceTypes(
      List<InterfaceDescription> required, List<Port.Data> outputPorts, Method method) {
    this.required = required;
    this.outputPorts = outputPorts;
    this.method = method;
  }

  /** Resolves the types of a model. They are not changed if its target is not found. */
  static TestModel resolve(
      TestModel given,
      List<InterfaceDescription> provided,
      List<InterfaceDescription> required,
      List<Port.Data> outputPorts) {
    TestModel model = given.withConstants(InterfaceConstants.of(provided, required));
    SequenceSpec sequence = model.sequence();
    return sequence == null
        ? resolveCall(model, provided, required, outputPorts)
        : new SequenceTypes(provided, required)
            .resolve(model, sequence, call -> resolveCall(call, provided, required, outputPorts));
  }

  private static TestModel resolveCall(
      TestModel model,
      List<InterfaceDescription> provided,
      List<InterfaceDescription> required,
      List<Port.Data> outputPorts) {
    try {
      var types =
          new InterfaceTypes(required, outputPorts, TargetMethod.find(model, provided).method());
      return model
          .withInputs(model.inputs().stream().map(types::resolve).toList())
          .withOutputs(model.outputs().stream().map(types::resolve).toList());
    } catch (IllegalArgumentException e) {
      // Reported by ModelAgainstActivity.
      return model;
    }
  }

  private InputElement resolve(InputElement input) {
    Optional<DataType> type =
        switch (input.kind()) {
          case TDI -> parameter(method, input.name());
          case TDTS -> answer(input.name());
          case TDSD -> Optional.empty();
        };
    return type.filter(t -> isKnownOnlyTo(t, input.type())).map(input::withType).orElse(input);
  }

  private OutputElement resolve(OutputElement output) {
    Optional<DataType> type =
        switch (output.kind()) {
          case RETURN -> MemberPath.resolve(method.returnType(), output.name());
          case OUT -> parameter(method, output.name());
          case OBSERVED ->
              OutputPorts.named(outputPorts, output.name())
                  .flatMap(port -> MemberPath.resolve(port.type(), output.name()));
        };
    return type.filter(t -> isKnownOnlyTo(t, output.type())).map(output::withType).orElse(output);
  }

  private Optional<DataType> answer(String name) {
    Matcher parts = STUB_NAME.matcher(name);
    if (!parts.matches()) {
      return Optional.empty();
    }
    Optional<Method> called =
        required.stream()
            .filter(i -> i.name().equals(parts.group(1)))
            .flatMap(i -> i.methodsNamed(parts.group(2)).stream())
            .findFirst();
    return parts.group(3) == null
        ? called.map(Method::returnType)
        : called.flatMap(m -> parameter(m, parts.group(3)));
  }

  private static Optional<DataType> parameter(Method method, String name) {
    return method.parameters().stream()
        .filter(p -> p.name().equals(MemberPath.root(name)))
        .findFirst()
        .map(Parameter::type)
        .flatMap(t -> MemberPath.resolve(t, name));
  }

  /** The type of a scalar is defined by the model and may differ from the interface. */
  private static boolean isKnownOnlyTo(DataType inInterface, DataType inModel) {
    return inInterface instanceof DataType.Enumeration
        || (holdsUnknown(inModel) && !(inInterface instanceof DataType.Scalar));
  }

  private static boolean holdsUnknown(DataType type) {
    return type instanceof DataType.Unknown
        || type.parts().stream().anyMatch(InterfaceTypes::holdsUnknown);
  }
}
