package org.sitaf.core.harness.java.plan;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.Direction;
import org.sitaf.core.model.Tolerance;

/**
 * A test application in Java, decided: every name is one that Java can spell, every type has a
 * spelling.
 *
 * @param packageName of the driver
 * @param method the method under test, as {@code Interface.method}
 * @param description what the model says of itself
 * @param component type of the component, as sources name it
 * @param componentImport what to import for it; null where it is named in full
 * @param suiteLife whether the component lives as long as the suite
 * @param arguments in the order of the method's parameters
 * @param returns null where the method returns nothing
 * @param world what the simulation sets; null where the activity names no world
 * @param stubs of the required interfaces
 * @param outputs what is looked at after the call
 * @param properties of the component, by name
 * @param before calls that set the component up, as statements without the component
 */
public record JavaPlan(
    String modelName,
    String packageName,
    String interfaceName,
    String method,
    String description,
    String component,
    @Nullable String componentImport,
    boolean suiteLife,
    List<Argument> arguments,
    @Nullable JavaType returns,
    @Nullable World world,
    List<Stub> stubs,
    List<Output> outputs,
    Map<String, String> properties,
    List<Call> before) {

  /**
   * A parameter of the method under test.
   *
   * @param name as the interface has it
   * @param local its variable
   * @param given whether the suite has a value for it
   */
  public record Argument(
      String name, String local, JavaType type, Direction direction, boolean given) {
    /** The type of the variable. */
    public String declared() {
      return direction == Direction.IN ? type.name() : "Out<" + type.boxed() + ">";
    }

    /** The variable's declaration as a parameter. */
    public String parameter() {
      return declared() + " " + local;
    }
  }

  /** The world of the activity and what the suite sets in it. */
  public record World(String path, List<Setting> settings, Duration settle, Duration runFor) {
    /**
     * A parameter of the world that the suite sets (TDSD).
     *
     * @param documentation its unit and range, fit for a comment
     */
    public record Setting(String name, String local, String documentation) {}
  }

  /**
   * A required interface.
   *
   * @param name of the interface, and of the Java interface
   * @param field of the test stub that implements it
   */
  public record Stub(String name, String source, String field, List<StubMethod> methods) {}

  /**
   * A method of a required interface.
   *
   * @param returns null where it returns nothing
   * @param field of the test stub that holds its answer; empty where it returns nothing
   * @param answer what the suite calls its answer (TDTS); null where the suite sets none
   */
  public record StubMethod(
      String name,
      @Nullable JavaType returns,
      List<String> parameters,
      String field,
      @Nullable String answer) {
    public String returnName() {
      return returns == null ? "void" : returns.name();
    }
  }

  /**
   * Something that is looked at after the call.
   *
   * @param expression that gives it
   * @param tolerance null where nothing is expected of it
   */
  public record Output(
      String name, String expression, boolean observed, @Nullable Tolerance tolerance) {}

  /** A call of the component, with arguments as expressions. */
  public record Call(String method, List<String> arguments) {}

  /** The return type as sources spell it. */
  public String returnName() {
    return returns == null ? "void" : returns.name();
  }

  /** Whether anything is observed in the world after the call. */
  public boolean observes() {
    return outputs.stream().anyMatch(Output::observed);
  }

  /** The answers that the suite sets. */
  public List<StubMethod> answers() {
    return stubs.stream()
        .flatMap(s -> s.methods().stream())
        .filter(m -> m.answer() != null)
        .toList();
  }
}
