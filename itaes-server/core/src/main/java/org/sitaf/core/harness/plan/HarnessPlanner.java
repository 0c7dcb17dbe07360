package org.sitaf.core.harness.plan;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.TargetMethod;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.WorldDescription;
import org.sitaf.core.description.fault.FaultKind;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.description.source.ComponentDescription.Port;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.plan.HarnessPlan.Argument;
import org.sitaf.core.harness.plan.HarnessPlan.Output;
import org.sitaf.core.harness.plan.HarnessPlan.Source;
import org.sitaf.core.harness.plan.HarnessPlan.Stub;
import org.sitaf.core.harness.plan.HarnessPlan.World;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.TestSuite;

/**
 * Plans a test application independent of its language, and reports everything that no language can
 * express.
 */
public final class HarnessPlanner {
  /** The document of the test profile, for diagnostics. */
  public static final String PROFILE = "activity.yaml";

  private final Activity activity;
  private final TestModel model;
  private final TestSuite suite;
  private final Diagnostics diagnostics;

  HarnessPlanner(Activity activity, TestModel model, TestSuite suite, Diagnostics diagnostics) {
    this.activity = activity;
    this.model = model;
    this.suite = suite;
    this.diagnostics = diagnostics;
  }

  /**
   * Plans a test application.
   *
   * @param diagnostics receives problems; parts of the plan with errors are missing
   * @throws InvalidInputException if the method under test is not found
   */
  public static HarnessPlan plan(
      Activity activity, TestModel model, TestSuite suite, Diagnostics diagnostics) {
    return new HarnessPlanner(activity, model, suite, diagnostics).plan();
  }

  /**
   * Plans the adapter of a component, or the skeleton of a component without an adapter.
   *
   * @param diagnostics receives problems
   */
  public static HarnessPlan.Adapter adapter(Activity activity, Diagnostics diagnostics) {
    boolean answers = activity.profile().component().adapter() == null;
    // A component without an adapter need not have the methods that cannot be tested.
    List<InterfaceDescription> provided =
        new DeclaredExceptions(diagnostics)
            .withSimpleNames(activity.provided()).stream()
                .map(i -> answers ? i.withMethods(m -> !holdsUnknown(m)) : i)
                .toList();
    DeclaredTypes types = new DeclaredTypes(diagnostics);
    for (InterfaceDescription description : provided) {
      for (Method method : description.methods()) {
        if (StubPlanner.checkNames(description, method, diagnostics)) {
          types.reach(description.source(), method);
        }
      }
    }
    if (provided.isEmpty()) {
      diagnostics.error(
          PROFILE, 0, "provided", "contains no interface that an adapter could implement");
    }
    return new HarnessPlan.Adapter(
        activity.profile().component().className(),
        provided,
        activity.required().stream().map(InterfaceDescription::name).toList(),
        activity.world() != null,
        answers);
  }

  private HarnessPlan plan() {
    var exceptions = new DeclaredExceptions(diagnostics);
    List<InterfaceDescription> provided = exceptions.withSimpleNames(activity.provided());
    List<InterfaceDescription> required = exceptions.withSimpleNames(activity.required());
    List<TargetMethod> targets = targets(provided);
    TargetMethod target = targets.get(0);
    Method method = target.method();
    Component component = activity.profile().component();
    if (component.period() != null && activity.world() == null) {
      diagnostics.error(
          PROFILE,
          0,
          "component.execution",
          "a periodic component is executed in simulation time; add a world to activity.yaml");
    }
    SequenceSpec steps = model.sequence();
    List<Argument> arguments =
        steps == null ? new ArgumentPlanner(target, model, suite, diagnostics).plan() : List.of();
    World world = world();
    StubPlanner stubPlanner = new StubPlanner(required, model, suite, diagnostics);
    List<Stub> stubs = stubPlanner.plan();
    List<Output> outputs =
        steps == null ? new OutputPlanner(method, model, activity, diagnostics).plan() : List.of();
    var before = new BeforeCalls(provided, diagnostics).plan(component.before(), PROFILE);
    List<Output> watched = WatchedPorts.of(activity, model);
    DeclaredTypes types = new DeclaredTypes(diagnostics);
    targets.forEach(t -> types.reach(t.declaring().source(), t.method()));
    for (InterfaceDescription description : required) {
      description.methods().forEach(m -> types.reach(description.source(), m));
    }
    before.forEach(call -> types.reach(PROFILE, call.method()));
    // The component uses the types of all its methods; an adapter implements all of them.
    for (InterfaceDescription description : provided) {
      description.methods().stream()
          .filter(m -> component.adapter() != null || !holdsUnknown(m))
          .forEach(m -> types.reach(description.source(), m));
    }
    // The component also uses the types of all its ports.
    for (Port.Data port : activity.outputPorts()) {
      if (!holdsUnknown(port.type()) || isObserved(port, outputs) || isObserved(port, watched)) {
        types.reach(PROFILE, port);
      }
    }
    SortedSet<String> errors = new TreeSet<>(stubPlanner.errors());
    errors.addAll(exceptions.names());
    HarnessPlan plan =
        new HarnessPlan(
            model.name(),
            model.description(),
            target.declaring().name(),
            method,
            component,
            arguments,
            outputs,
            world,
            stubs,
            before,
            provided,
            types.inOrder(),
            List.copyOf(errors),
            activity.profile().limits(),
            watched,
            null);
    return steps == null
        ? plan
        : new SequencePlanner(activity, model, steps, suite, required, diagnostics)
            .plan(plan, targets);
  }

  /** The method under test, or those of the calls of a sequence. */
  private List<TargetMethod> targets(List<InterfaceDescription> provided) {
    SequenceSpec steps = model.sequence();
    List<TargetMethod> targets = new ArrayList<>();
    for (TestModel called :
        steps == null ? List.of(model) : steps.calls().stream().map(SequenceCall::model).toList()) {
      try {
        targets.add(TargetMethod.find(called, provided));
      } catch (IllegalArgumentException e) {
        throw InvalidInputException.of(model.source(), "target: " + e.getMessage());
      }
    }
    if (targets.isEmpty()) {
      throw InvalidInputException.of(
          model.source(), "sequence_spec: contains no call; a test needs at least one");
    }
    return targets;
  }

  private static boolean isObserved(Port.Data port, List<Output> outputs) {
    return outputs.stream()
        .anyMatch(
            o -> o.source() instanceof Source.DataPort data && data.port().equals(port.name()));
  }

  private static boolean holdsUnknown(Method method) {
    return holdsUnknown(method.returnType())
        || method.parameters().stream().anyMatch(p -> holdsUnknown(p.type()));
  }

  private static boolean holdsUnknown(DataType type) {
    return type instanceof DataType.Unknown
        || type.parts().stream().anyMatch(HarnessPlanner::holdsUnknown);
  }

  private static World.Setting fault(FaultName name) {
    boolean isTime = name.part() == FaultName.Part.AT || name.part() == FaultName.Part.FOR;
    boolean isTruth = name.part() == FaultName.Part.FAULT && name.kind().isSwitch();
    boolean isUnlimited =
        name.part() == FaultName.Part.VALUE
            || name.kind() == FaultKind.OFFSET
            || name.kind() == FaultKind.SCALE;
    return new World.Setting(
        name.text(),
        isTime || name.kind() == FaultKind.DELAY ? "s" : "1",
        isUnlimited && !isTime ? Double.NEGATIVE_INFINITY : 0,
        isTruth || (!isTime && name.kind() == FaultKind.INTERMITTENT)
            ? 1
            : Double.POSITIVE_INFINITY);
  }

  /** The world with the parameters that the suite sets; null if the activity has none. */
  @Nullable World world() {
    WorldDescription description = activity.world();
    List<World.Setting> settings = new ArrayList<>();
    for (CaseParameter parameter : suite.parameters()) {
      if (parameter.kind() != InputKind.TDSD) {
        continue;
      }
      Optional<FaultName> fault = FaultName.find(parameter.name());
      if (description != null && fault.isPresent()) {
        settings.add(fault(fault.get()));
      } else if (description == null || description.parameter(parameter.name()).isEmpty()) {
        diagnostics.error(
            model.source(),
            0,
            "test_element " + parameter.name(),
            description == null
                ? "is a parameter of the world, but activity.yaml has no world"
                : description.path() + " has no such parameter");
      } else if (!Words.isWord(parameter.name())) {
        diagnostics.error(
            description.path(), 0, "parameters", "'" + parameter.name() + "' is not an identifier");
      } else {
        var declared = description.parameter(parameter.name()).get();
        settings.add(
            new World.Setting(parameter.name(), declared.unit(), declared.min(), declared.max()));
      }
    }
    return description == null
        ? null
        : new World(description.path(), settings, model.target().settle(), model.target().runFor());
  }
}
