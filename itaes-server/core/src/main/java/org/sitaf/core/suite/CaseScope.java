package org.sitaf.core.suite;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Objects;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.expression.Scope;
import org.sitaf.core.expression.VariableTypes;
import org.sitaf.core.expression.Variables;
import org.sitaf.core.expression.type.Type;
import org.sitaf.core.model.InputElement;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.sequence.SequenceCall;
import org.sitaf.core.model.sequence.SequenceSpec;

/** The names that the expressions of a model can use. */
public final class CaseScope {
  private CaseScope() {}

  /** Pre-conditions: the inputs and whether they are valid. */
  public static Scope ofInputs(TestModel model) {
    return scope(model, inputs(model));
  }

  /** Expected values: the inputs and, of a call in a sequence, its surroundings. */
  public static Scope beforeCall(TestModel model) {
    Map<String, Type> variables = new LinkedHashMap<>(surroundings(model));
    variables.putAll(inputs(model));
    return scope(model, variables);
  }

  /** Guards of steps: the abstract state. */
  public static Scope ofStates(TestModel model) {
    Map<String, Type> variables = new LinkedHashMap<>();
    Objects.requireNonNull(model.sequence())
        .states()
        .forEach(s -> variables.put(s.name(), Type.of(s.type())));
    return scope(model, variables);
  }

  /** Updates of the abstract state by a call: the state before it and its inputs. */
  public static Scope ofUpdates(TestModel model, SequenceCall call) {
    Map<String, Type> variables = new LinkedHashMap<>(ofStates(model).variables());
    variables.putAll(inputs(call.model()));
    return scope(model, variables);
  }

  /** The steps of a sequence, for the model's own post-conditions. */
  private static Map<String, Type> steps(TestModel model) {
    if (model.sequence() == null) {
      return Map.of();
    }
    Map<String, Type> step = new LinkedHashMap<>();
    step.put("name", Type.TEXT);
    step.put("inputs", new Type.Mapping(Type.ANY));
    step.put("outputs", new Type.Mapping(Type.ANY));
    step.put(Variables.ERROR, Type.TEXT);
    step.put("time", Type.REAL);
    return Map.of(SequenceSpec.STEPS, new Type.Sequence(new Type.Members("", step)));
  }

  private static Map<String, Type> surroundings(TestModel model) {
    Map<String, Type> types = new LinkedHashMap<>();
    model.surroundings().forEach((name, type) -> types.put(name, Type.of(type)));
    return types;
  }

  /** Post-conditions: also the outputs, the error and the calls of required interfaces. */
  public static Scope afterCall(TestModel model) {
    Map<String, Type> variables = new LinkedHashMap<>();
    VariableTypes outputs = new VariableTypes();
    for (OutputElement output : model.outputs()) {
      Type type = Type.of(output.type());
      outputs.put("actual_" + output.name(), type);
      if (MemberPath.root(output.name()).equals(OutputElement.RETURN_NAME)) {
        outputs.put("actual" + output.name().substring(OutputElement.RETURN_NAME.length()), type);
      }
    }
    variables.put("actual", Type.ANY);
    variables.putAll(outputs.map());
    variables.put(Variables.ERROR, Type.TEXT);
    variables.put(Variables.MESSAGES, new Type.Mapping(new Type.Sequence(Type.ANY)));
    variables.putAll(steps(model));
    variables.putAll(surroundings(model));
    // An input named error or messages hides them.
    variables.putAll(inputs(model));
    variables.put(Variables.CALLS, new Type.Mapping(new Type.Sequence(Type.ANY)));
    return scope(model, variables);
  }

  /**
   * Conditions of relations: the inputs of the first run, and the outputs and the error of both
   * runs.
   */
  static Scope betweenRuns(TestModel model) {
    VariableTypes outputs = new VariableTypes();
    for (OutputElement output : model.outputs()) {
      if (!output.type().isVoid()) {
        outputs.put(inRun(output.name()), Type.of(output.type()));
      }
    }
    Map<String, Type> members = new LinkedHashMap<>(outputs.map());
    if (!hasReturn(model)) {
      members.putIfAbsent(Relations.VALUE, Type.ANY);
    }
    members.put(Variables.ERROR, Type.TEXT);
    Map<String, Type> variables = new LinkedHashMap<>(inputs(model));
    variables.put(Relations.BEFORE, new Type.Members("", members));
    variables.put(Relations.AFTER, new Type.Members("", members));
    return scope(model, variables);
  }

  /** Whether the model declares the return value or members of it. */
  private static boolean hasReturn(TestModel model) {
    return model.outputs().stream()
        .anyMatch(o -> MemberPath.root(o.name()).equals(OutputElement.RETURN_NAME));
  }

  /** The path of an output in the map of a run: {@code return.x} is {@code value.x} there. */
  public static String inRun(String output) {
    return MemberPath.root(output).equals(OutputElement.RETURN_NAME)
        ? Relations.VALUE + output.substring(OutputElement.RETURN_NAME.length())
        : output;
  }

  /** A copy in which nothing is known about some names. */
  static Scope open(Scope scope, Collection<String> names) {
    Map<String, DataType> unknown = new LinkedHashMap<>();
    names.forEach(name -> unknown.put(name, new DataType.Unknown("")));
    return scope.with(unknown);
  }

  private static Scope scope(TestModel model, Map<String, Type> variables) {
    return new Scope(variables, model.definitions(), model.constants());
  }

  private static Map<String, Type> inputs(TestModel model) {
    VariableTypes validity = new VariableTypes();
    VariableTypes inputs = new VariableTypes();
    for (InputElement input : model.inputs()) {
      validity.put(Variables.VALID_PREFIX + input.name(), Type.BOOLEAN);
      // A stub may also answer with an error or a delay.
      inputs.put(input.name(), input.kind() == InputKind.TDTS ? Type.ANY : Type.of(input.type()));
    }
    Map<String, Type> variables = new LinkedHashMap<>(validity.map());
    variables.put(Variables.VALID, Type.BOOLEAN);
    variables.putAll(inputs.map());
    return variables;
  }
}
