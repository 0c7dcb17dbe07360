package org.sitaf.core.activity;

import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.hardware.DeviceBackend;
import org.sitaf.core.activity.ros.MessageSignals;
import org.sitaf.core.activity.ros.RosElements;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.TypeGrammar;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.WorldSignals;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.timing.Timing;
import org.sitaf.core.trajectory.TrajectoryConditions;
import org.sitaf.core.value.TestDataGenerator;

/** Verifies a test model against the interfaces and the world of its activity. */
final class ModelAgainstActivity {
  /**
   * {@code Interface.Method}, {@code Interface.Method.param}, each optionally followed by {@code
   * #2}.
   */
  private static final Pattern STUB_NAME =
      Pattern.compile("(\\w+)\\.(\\w+)(?:\\.(\\w+))?(?:#[1-9][0-9]*)?");

  private final TestModel model;
  private final List<InterfaceDescription> required;
  private final @Nullable WorldDescription world;
  private final List<Port.Data> outputPorts;
  private final ActivityProfile profile;
  private final @Nullable RosNode ros;
  private final @Nullable InterfaceDescription messages;
  private final Diagnostics diagnostics = new Diagnostics();
  private final WorldInputs worldInputs;

  private ModelAgainstActivity(
      TestModel model,
      List<InterfaceDescription> required,
      @Nullable WorldDescription world,
      List<Port.Data> outputPorts,
      ActivityProfile profile,
      @Nullable InterfaceDescription messages) {
    this.profile = profile;
    this.messages = messages;
    this.ros = profile.ros();
    this.model = model;
    this.required = required;
    this.world = world;
    this.outputPorts = outputPorts;
    this.worldInputs = new WorldInputs(model, world, diagnostics);
  }

  /**
   * Verifies a model.
   *
   * @param messages of a node, for trajectory conditions; null if the component is none
   */
  static List<Diagnostic> verify(
      TestModel model,
      List<InterfaceDescription> provided,
      List<InterfaceDescription> required,
      @Nullable WorldDescription world,
      List<Port.Data> outputPorts,
      ActivityProfile profile,
      @Nullable InterfaceDescription messages) {
    var verification =
        new ModelAgainstActivity(model, required, world, outputPorts, profile, messages);
    verification.timing();
    verification.realDevices();
    if (model.sequence() != null) {
      verification.initialInputs();
      verification.trajectories();
      verification.diagnostics.addAll(
          new SequenceAgainstActivity(model, model.sequence(), world)
              .verify(c -> verify(c, provided, required, world, outputPorts, profile, messages)));
      return verification.diagnostics.all();
    }
    try {
      Method method = TargetMethod.find(model, provided).method();
      verification.inputs(method);
      verification.outputs(method);
      verification.trajectories();
    } catch (IllegalArgumentException e) {
      verification.error(0, "target", String.valueOf(e.getMessage()));
    }
    return verification.diagnostics.all();
  }

  private void timing() {
    Timing timing = model.timing();
    if (timing != null && profile.component().lifeCycle() == LifeCycle.SUITE) {
      error(timing.line(), "timing", ProfileReader.TIMING_NEEDS_CASE);
    }
  }

  /** A second run would use the readings of another moment. */
  private void realDevices() {
    if (!model.relations().isEmpty()
        && profile.hardware().stream().anyMatch(DeviceBackend::isReal)) {
      error(
          0,
          "relation_list",
          "compares two runs, but the real devices of activity.yaml (hardware) differ between them;"
              + " simulate these devices");
    }
  }

  /** What is set before the first step of a sequence. A TDI is a property of the component. */
  private void initialInputs() {
    for (InputElement input : model.inputs()) {
      wholeValues(input);
      if (ros != null && RosElements.isOne(input)) {
        RosElements.initialProblem(input)
            .ifPresent(p -> error(input.line(), "test_element " + input.name(), p));
        continue;
      }
      switch (input.kind()) {
        case TDI -> {
          // A property or constructor argument, which the component's profile need not declare.
        }
        case TDSD -> worldInputs.verify(input);
        case TDTS -> stubValue(input);
      }
    }
  }

  private void inputs(Method method) {
    Set<String> given = new HashSet<>();
    for (InputElement input : model.inputs()) {
      wholeValues(input);
      if (ros != null && RosElements.isOne(input)) {
        RosElements.problem(input, method, ros)
            .ifPresent(p -> error(input.line(), "test_element " + input.name(), p));
        continue;
      }
      switch (input.kind()) {
        case TDI -> {
          given.add(MemberPath.root(input.name()));
          argument(input, method);
        }
        case TDSD -> worldInputs.verify(input);
        case TDTS -> stubValue(input);
      }
    }
    for (Parameter parameter : ros == null ? method.parameters() : List.<Parameter>of()) {
      // What is not named in a message has the default of its type.
      if (parameter.direction() == Direction.IN && !given.contains(parameter.name())) {
        error(
            0,
            "input_spec_list",
            "parameter "
                + parameter.name()
                + " of "
                + method.name()
                + " has no test_element of type TDI");
      }
    }
  }

  /** Whether the resolved type can hold the values of the specifications. */
  private void wholeValues(InputElement input) {
    if (input.type() instanceof DataType.Scalar || input.specs().isEmpty()) {
      return;
    }
    try {
      var unused = TestDataGenerator.generate(input, 1);
    } catch (IllegalArgumentException e) {
      error(
          input.line(),
          "test_element " + input.name() + "/test_spec",
          String.valueOf(e.getMessage()));
    }
  }

  private void argument(InputElement input, Method method) {
    Optional<Parameter> parameter = parameter(method, MemberPath.root(input.name()));
    if (parameter.isEmpty() || parameter.get().direction() == Direction.OUT) {
      error(
          input.line(),
          "test_element " + input.name(),
          method.name()
              + " has no such parameter; it has "
              + method.parameters().stream()
                  .map(Parameter::name)
                  .collect(Collectors.joining(", ")));
      return;
    }
    Optional<DataType> type = MemberPath.resolve(parameter.get().type(), input.name());
    if (type.isEmpty()) {
      error(
          input.line(),
          "test_element " + input.name(),
          MemberPath.missing(parameter.get().type(), input.name()));
    } else {
      sameType(input.line(), input.name(), input.realType(), type.get());
      literals(input, type.get());
    }
  }

  private void literals(InputElement input, DataType type) {
    if (type instanceof DataType.Enumeration enumeration) {
      input.userValues().stream()
          .map(Value::literal)
          .filter(literal -> !enumeration.literals().contains(literal))
          .forEach(
              literal ->
                  error(
                      input.line(),
                      "test_element " + input.name(),
                      "'"
                          + literal
                          + "' is not a literal of "
                          + enumeration.name()
                          + "; known literals: "
                          + enumeration.literals()));
    }
  }

  private void stubValue(InputElement input) {
    Matcher name = STUB_NAME.matcher(input.name());
    String where = "test_element " + input.name();
    if (!name.matches()) {
      error(
          input.line(),
          where,
          "must be named Interface.Method or Interface.Method.param, optionally followed by #2");
      return;
    }
    Optional<InterfaceDescription> called =
        required.stream().filter(i -> i.name().equals(name.group(1))).findFirst();
    if (called.isEmpty()) {
      error(
          input.line(),
          where,
          "activity.yaml does not require the interface "
              + name.group(1)
              + "; required interfaces: "
              + required.stream().map(InterfaceDescription::name).toList());
      return;
    }
    List<Method> methods = called.get().methodsNamed(name.group(2));
    if (methods.isEmpty()) {
      error(input.line(), where, name.group(1) + " has no method " + name.group(2));
    } else if (name.group(3) == null && !methods.get(0).returnType().isVoid()) {
      sameType(input.line(), input.name(), input.realType(), methods.get(0).returnType());
    } else if (name.group(3) != null && parameter(methods.get(0), name.group(3)).isEmpty()) {
      error(input.line(), where, name.group(2) + " has no parameter " + name.group(3));
    }
  }

  private void outputs(Method method) {
    for (OutputElement output : model.outputs()) {
      String where = "test_element " + output.name();
      switch (output.kind()) {
        case RETURN -> {
          if (method.returnType().isVoid()) {
            if (!output.type().isVoid() || !output.name().equals(OutputElement.RETURN_NAME)) {
              error(
                  output.line(),
                  where,
                  method.name()
                      + " returns nothing; use an element named return with abstract_type VOID and"
                      + " real_type void, which expects null or an error such as \"!error:NAME\"");
            }
          } else {
            Optional<DataType> part = MemberPath.resolve(method.returnType(), output.name());
            if (part.isEmpty()) {
              error(output.line(), where, MemberPath.missing(method.returnType(), output.name()));
            } else {
              sameType(output.line(), output.name(), output.realType(), part.get());
            }
          }
        }
        case OUT -> {
          Optional<Parameter> parameter = parameter(method, MemberPath.root(output.name()));
          if (parameter.isEmpty() || parameter.get().direction() == Direction.IN) {
            error(
                output.line(),
                where,
                ros == null
                    ? method.name() + " has no out-parameter of this name"
                    : "is no output; write output." + output.name() + " at a topic");
          } else if (ros != null && !RosElements.isCount(output.name())) {
            Optional<DataType> part = MemberPath.resolve(parameter.get().type(), output.name());
            if (part.isEmpty()) {
              error(
                  output.line(), where, MemberPath.missing(parameter.get().type(), output.name()));
            } else {
              sameType(output.line(), output.name(), output.realType(), part.get());
            }
          }
        }
        case OBSERVED -> observed(output, where);
      }
    }
  }

  private void trajectories() {
    if (!model.trajectoryConditions().isEmpty() && world == null) {
      error(
          model.trajectoryConditions().get(0).line(),
          "trajectory_condition_spec_list",
          "needs a simulation, but activity.yaml has no world");
    } else if (world != null) {
      InterfaceDescription sent = sent();
      TrajectoryConditions.compile(
          model,
          Stream.of(
                  WorldSignals.of(world),
                  DeviceBackend.signals(profile.hardware()),
                  sent == null ? List.<String>of() : MessageSignals.of(sent),
                  PortSignals.of(outputPorts),
                  model.sequence() == null ? List.<String>of() : List.of(SequenceSpec.STEP))
              .flatMap(List::stream)
              .toList(),
          lists(),
          profile.limits().caseSimulation().toNanos() / 1e9,
          diagnostics);
    }
  }

  /** The messages that are signals; those of a sequence count from the call of each step. */
  private @Nullable InterfaceDescription sent() {
    return model.sequence() == null ? messages : null;
  }

  private Map<String, Integer> lists() {
    Map<String, Integer> lists = new TreeMap<>(PortSignals.lists(outputPorts));
    if (world != null) {
      lists.putAll(WorldSignals.lists(world));
    }
    InterfaceDescription sent = sent();
    if (sent != null) {
      lists.putAll(MessageSignals.lists(sent));
    }
    return lists;
  }

  private void observed(OutputElement output, String where) {
    boolean shown = world != null && world.observations().contains(output.name());
    Optional<Port.Data> port = OutputPorts.named(outputPorts, output.name());
    if (shown && port.isPresent()) {
      error(
          output.line(),
          where,
          "is both an observation of "
              + world.path()
              + " and an output data port; rename one of them");
    } else if (port.isPresent()) {
      Optional<DataType> part = MemberPath.resolve(port.get().type(), output.name());
      if (part.isEmpty()) {
        error(output.line(), where, MemberPath.missing(port.get().type(), output.name()));
      } else {
        sameType(output.line(), output.name(), output.realType(), part.get());
      }
    } else if (!shown) {
      error(
          output.line(),
          where,
          "is neither an observation of the world"
              + (world == null
                  ? ", since activity.yaml has no world"
                  : " in " + world.path() + ", which defines " + world.observations())
              + ", nor one of the output data ports "
              + outputPorts.stream().map(Port.Data::name).toList());
    }
  }

  /**
   * Checks that a type matches. An integer may be passed as a floating-point number; otherwise the
   * types must be of the same kind.
   */
  private void sameType(int line, String element, String realType, DataType wanted) {
    DataType given = TypeGrammar.parse(realType).type();
    if (given instanceof DataType.Scalar g && wanted instanceof DataType.Scalar w) {
      boolean fits =
          g.type() == w.type()
              || (g.type().isInteger() && w.type().isNumeric())
              || (g.type().isFloating() && w.type().isFloating());
      if (!fits) {
        error(
            line,
            "test_element " + element,
            "real_type "
                + realType
                + " does not match the interface, which declares "
                + wanted.typeName());
      }
    }
  }

  private static Optional<Parameter> parameter(Method method, String name) {
    return method.parameters().stream().filter(p -> p.name().equals(name)).findFirst();
  }

  private void error(int line, String element, String message) {
    diagnostics.error(model.source(), line, element, message);
  }
}
