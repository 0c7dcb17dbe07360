package org.sitaf.core.harness.java.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.TargetMethod;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.java.plan.HarnessPlan.Argument;
import org.sitaf.core.harness.java.plan.HarnessPlan.Output;
import org.sitaf.core.harness.java.plan.HarnessPlan.World;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestSuite;

/**
 * Decides about a test application before anything is printed, and says everything that Java cannot
 * express.
 */
public final class HarnessPlanner {
  private static final String PROFILE = "activity.yaml";
  private static final DataType VOID = new DataType.Scalar(ScalarType.VOID);

  private final Activity activity;
  private final TestModel model;
  private final TestSuite suite;
  private final Diagnostics diagnostics = new Diagnostics();
  private final JavaNames names;

  private HarnessPlanner(Activity activity, TestModel model, TestSuite suite) {
    this.activity = activity;
    this.model = model;
    this.suite = suite;
    this.names = new JavaNames(activity.profile().component().className().split("\\.", 2)[0]);
  }

  /**
   * Plans a test application.
   *
   * @throws InvalidInputException with everything that has no spelling in Java
   */
  public static HarnessPlan plan(Activity activity, TestModel model, TestSuite suite) {
    return new HarnessPlanner(activity, model, suite).plan();
  }

  /** The package of a model's test application. */
  public static String packageName(TestModel model) {
    return "sitaf.harness." + JavaNames.packagePart(model.name());
  }

  private HarnessPlan plan() {
    TargetMethod target;
    try {
      target = TargetMethod.find(model, activity.provided());
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of(model.source(), "target: " + e.getMessage());
    }
    Method method = target.method();
    Component component = activity.profile().component();
    String className = component.className().replace('$', '.');
    String simpleName = className.substring(className.lastIndexOf('.') + 1);
    className(className);
    if (component.period() != null) {
      diagnostics.error(
          PROFILE,
          0,
          "component.execution",
          "periodic components are not driven in Java tests yet; with execution: passive the method"
              + " under test is called once a case");
    }
    List<Argument> arguments = arguments(target);
    suiteParameters(method);
    World world = world();
    var stubs = new StubPlanner(activity.required(), model, suite, names, diagnostics).plan();
    @Nullable JavaType returns =
        method.returnType().equals(VOID)
            ? null
            : type(target, method.returnType(), "its return type");
    List<Output> outputs = outputs(method, arguments, world);
    var before =
        new BeforeCalls(activity.provided(), diagnostics).plan(component.before(), PROFILE);
    diagnostics.throwIfErrors();
    boolean clash = JavaNames.isUsedType(simpleName);
    return new HarnessPlan(
        model.name(),
        packageName(model),
        target.declaring().name(),
        method.name(),
        model.description(),
        clash ? className : simpleName,
        clash ? null : className,
        component.lifeCycle() == LifeCycle.SUITE,
        arguments,
        returns,
        world,
        stubs,
        outputs,
        component.properties(),
        before);
  }

  private void className(String className) {
    String[] parts = className.split("\\.", -1);
    for (String part : parts) {
      if (!JavaNames.isTypeName(part)) {
        diagnostics.error(
            PROFILE,
            0,
            "component.class",
            "'" + className + "' is not the qualified name of a Java class");
        return;
      }
    }
    if (parts.length == 1) {
      diagnostics.error(
          PROFILE,
          0,
          "component.class",
          className + " must be in a package, so that a test can import it");
    }
  }

  private List<Argument> arguments(TargetMethod target) {
    Method method = target.method();
    String source = target.declaring().source();
    if (!JavaNames.isName(method.name())) {
      diagnostics.error(
          source,
          method.line(),
          "method " + method.name(),
          "is not a name that a Java method can have");
    }
    List<Argument> arguments = new ArrayList<>();
    for (Parameter parameter : method.parameters()) {
      if (!JavaNames.isWord(parameter.name())) {
        diagnostics.error(
            source,
            method.line(),
            "method " + method.name(),
            "parameter '" + parameter.name() + "' is not an identifier");
        continue;
      }
      boolean given = has(parameter.name(), InputKind.TDI);
      if (!given && parameter.direction() == Direction.IN) {
        diagnostics.error(
            model.source(),
            0,
            "input_spec_list",
            "the test cases hold no value for parameter "
                + parameter.name()
                + " of "
                + method.name()
                + ": add a test_element of type TDI");
      }
      JavaType type = type(target, parameter.type(), "parameter " + parameter.name());
      if (type != null) {
        String local = names.local(parameter.name());
        arguments.add(new Argument(parameter.name(), local, type, parameter.direction(), given));
      }
    }
    return arguments;
  }

  /** Every value of a case must have a place to go to. */
  private void suiteParameters(Method method) {
    for (CaseParameter parameter : suite.parameters()) {
      if (parameter.kind() != InputKind.TDI) {
        continue;
      }
      boolean known =
          method.parameters().stream()
              .anyMatch(p -> p.name().equals(parameter.name()) && p.direction() != Direction.OUT);
      if (!known) {
        boolean member = parameter.name().matches(".*[.\\[].*");
        diagnostics.error(
            model.source(),
            0,
            "test_element " + parameter.name(),
            member
                ? "members and elements of parameters cannot be set in a Java test application yet"
                : method.name() + " has no such input parameter");
      }
    }
  }

  private @Nullable World world() {
    WorldDescription description = activity.world();
    List<World.Setting> settings = new ArrayList<>();
    for (CaseParameter parameter : suite.parameters()) {
      if (parameter.kind() != InputKind.TDSD) {
        continue;
      }
      if (description == null || description.parameter(parameter.name()).isEmpty()) {
        diagnostics.error(
            model.source(),
            0,
            "test_element " + parameter.name(),
            description == null
                ? "is set through the simulation, but activity.yaml names no world"
                : description.path() + " has no such parameter");
      } else if (!JavaNames.isWord(parameter.name())) {
        diagnostics.error(
            description.path(), 0, "parameters", "'" + parameter.name() + "' is not an identifier");
      } else {
        var declared = description.parameter(parameter.name()).get();
        settings.add(
            new World.Setting(
                parameter.name(),
                names.local(parameter.name()),
                JavaText.comment(parameter.name())
                    + " in "
                    + JavaText.comment(declared.unit())
                    + ", from "
                    + declared.min()
                    + " to "
                    + declared.max()));
      }
    }
    return description == null
        ? null
        : new World(description.path(), settings, model.target().settle(), model.target().runFor());
  }

  /**
   * The return value and every out-parameter, whether or not the model looks at them, then what it
   * observes.
   */
  private List<Output> outputs(Method method, List<Argument> arguments, @Nullable World world) {
    List<Output> outputs = new ArrayList<>();
    Optional<OutputElement> returned =
        model.outputs().stream().filter(o -> o.kind() == OutputKind.RETURN).findFirst();
    if (!method.returnType().equals(VOID)) {
      String name = returned.map(OutputElement::name).orElse(OutputElement.RETURN_NAME);
      outputs.add(output(name, "returned", returned));
    } else {
      returned.ifPresent(o -> unknownOutput(o, method.name() + " returns nothing"));
    }
    for (Argument argument : arguments) {
      if (argument.direction() != Direction.IN) {
        outputs.add(
            output(
                argument.name(),
                argument.local() + ".get()",
                declared(argument.name(), OutputKind.OUT)));
      }
    }
    for (OutputElement element : model.outputs()) {
      if (element.kind() == OutputKind.OBSERVED) {
        if (world == null) {
          unknownOutput(element, "is observed in the simulation, but activity.yaml names no world");
        }
        String expression = "simulationControl.observe(" + JavaText.string(element.name()) + ")";
        outputs.add(new Output(element.name(), expression, true, element.tolerance()));
      } else if (outputs.stream().noneMatch(o -> o.name().equals(element.name()))) {
        unknownOutput(
            element,
            method.name()
                + " has no such output, or only a part of it is meant, which Java tests cannot yet");
      }
    }
    return outputs;
  }

  private Output output(String name, String expression, Optional<OutputElement> declared) {
    return new Output(name, expression, false, declared.map(OutputElement::tolerance).orElse(null));
  }

  private Optional<OutputElement> declared(String name, OutputKind kind) {
    return model.outputs().stream()
        .filter(o -> o.kind() == kind && o.name().equals(name))
        .findFirst();
  }

  private void unknownOutput(OutputElement output, String reason) {
    diagnostics.error(model.source(), output.line(), "test_element " + output.name(), reason);
  }

  private boolean has(String parameter, InputKind kind) {
    return suite.parameters().stream()
        .anyMatch(p -> p.kind() == kind && p.name().equals(parameter));
  }

  private @Nullable JavaType type(TargetMethod target, DataType type, String what) {
    Optional<JavaType> known = JavaType.of(type);
    if (known.isEmpty()) {
      Method method = target.method();
      diagnostics.error(
          target.declaring().source(),
          method.line(),
          "method " + method.name(),
          what + " is " + type.spelling() + "; " + JavaType.SUPPORTED);
    }
    return known.orElse(null);
  }
}
