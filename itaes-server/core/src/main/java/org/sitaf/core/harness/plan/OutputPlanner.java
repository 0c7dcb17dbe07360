package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.harness.plan.HarnessPlan.Output;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.TestModel;

/**
 * Plans the outputs: the return value and all out-parameters, whether or not the model uses them,
 * then the parts, observations and data ports of the model.
 */
final class OutputPlanner {
  private static final DataType NUMBER = new DataType.Scalar(ScalarType.DOUBLE);

  private final Method method;
  private final TestModel model;
  private final Activity activity;
  private final Diagnostics diagnostics;
  private final List<Output> outputs = new ArrayList<>();

  OutputPlanner(Method method, TestModel model, Activity activity, Diagnostics diagnostics) {
    this.method = method;
    this.model = model;
    this.activity = activity;
    this.diagnostics = diagnostics;
  }

  List<Output> plan() {
    if (!method.returnType().isVoid()) {
      Optional<OutputElement> element =
          model.outputs().stream()
              .filter(o -> o.kind() == OutputKind.RETURN && isWhole(o))
              .findFirst();
      String name = element.map(OutputElement::name).orElse(OutputElement.RETURN_NAME);
      add(name, new Source.Returned(List.of()), method.returnType(), element.orElse(null));
    }
    for (Parameter parameter : method.parameters()) {
      if (parameter.direction() != Direction.IN) {
        Optional<OutputElement> element =
            model.outputs().stream()
                .filter(o -> o.kind() == OutputKind.OUT && o.name().equals(parameter.name()))
                .findFirst();
        add(
            parameter.name(),
            new Source.OutParameter(parameter.name(), List.of()),
            parameter.type(),
            element.orElse(null));
      }
    }
    model.outputs().forEach(this::plan);
    return outputs;
  }

  private void plan(OutputElement element) {
    switch (element.kind()) {
      case RETURN -> {
        if (method.returnType().isVoid()) {
          add(element.name(), new Source.Returned(List.of()), method.returnType(), element);
        } else if (!isWhole(element)) {
          part(element, method.returnType())
              .ifPresent(
                  type ->
                      add(
                          element.name(),
                          new Source.Returned(MemberPath.steps(element.name())),
                          type,
                          element));
        }
      }
      case OUT -> {
        String root = MemberPath.root(element.name());
        Optional<Parameter> parameter =
            method.parameters().stream()
                .filter(p -> p.name().equals(root) && p.direction() != Direction.IN)
                .findFirst();
        if (parameter.isEmpty()) {
          unknown(element, method.name() + " has no out-parameter " + root);
        } else if (!isWhole(element)) {
          part(element, parameter.get().type())
              .ifPresent(
                  type ->
                      add(
                          element.name(),
                          new Source.OutParameter(root, MemberPath.steps(element.name())),
                          type,
                          element));
        }
      }
      case OBSERVED ->
          activity
              .outputPort(element.name())
              .ifPresentOrElse(port -> port(port, element), () -> observation(element));
    }
  }

  private void observation(OutputElement element) {
    if (activity.world() == null) {
      unknown(element, "is an observation of the world, but activity.yaml has no world");
    }
    add(element.name(), new Source.Observation(element.name()), NUMBER, element);
  }

  private void port(Port.Data port, OutputElement element) {
    if (!Words.isWord(port.name())) {
      unknown(element, "is a data port whose name is not a valid method name");
      return;
    }
    part(element, port.type())
        .ifPresent(
            type ->
                add(
                    element.name(),
                    new Source.DataPort(port.name(), MemberPath.steps(element.name())),
                    type,
                    element));
  }

  private static boolean isWhole(OutputElement element) {
    return MemberPath.root(element.name()).equals(element.name());
  }

  private Optional<DataType> part(OutputElement element, DataType whole) {
    Optional<DataType> type = MemberPath.resolve(whole, element.name());
    if (type.isEmpty()) {
      unknown(element, MemberPath.missing(whole, element.name()));
    }
    return type;
  }

  private void add(String name, Source source, DataType type, @Nullable OutputElement element) {
    if (outputs.stream().anyMatch(o -> o.name().equals(name))) {
      diagnostics.error(
          model.source(),
          element == null ? 0 : element.line(),
          "test_element " + name,
          "two outputs have this name");
      return;
    }
    outputs.add(new Output(name, source, type));
  }

  private void unknown(OutputElement element, String reason) {
    diagnostics.error(model.source(), element.line(), "test_element " + element.name(), reason);
  }
}
