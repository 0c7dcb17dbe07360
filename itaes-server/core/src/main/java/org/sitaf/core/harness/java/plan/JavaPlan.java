package org.sitaf.core.harness.java.plan;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.Direction;

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
 * @param notHooks methods of the component's interfaces that its life must not call
 * @param period of a periodic component; null for a passive one
 * @param beside whether the call is made on a thread of its own
 * @param arguments in the order of the method's parameters
 * @param returns null where the method returns nothing
 * @param world what the simulation sets; null where the activity names no world
 * @param interfaces that are generated beside the test
 * @param stubs of the required interfaces
 * @param outputs what is looked at after the call
 * @param properties of the component, by name
 * @param before calls that set the component up, as statements without the component
 * @param types structs and enumerations that are generated beside the test
 * @param errors exceptions that are generated beside the test
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
    List<String> notHooks,
    @Nullable Duration period,
    boolean beside,
    List<Argument> arguments,
    @Nullable JavaType returns,
    @Nullable World world,
    List<Interface> interfaces,
    List<Stub> stubs,
    List<Output> outputs,
    Map<String, String> properties,
    List<Call> before,
    List<JavaDeclaredType> types,
    List<String> errors) {

  /**
   * A parameter of the method under test.
   *
   * @param name as the interface has it
   * @param local its variable
   * @param reads what is read of the case for it, in order
   * @param value what it holds before the call; null for an out-parameter that the cases leave
   *     alone
   */
  public record Argument(
      String name,
      String local,
      JavaType type,
      Direction direction,
      List<Read> reads,
      @Nullable String value) {
    /** The type of the variable. */
    public String declared() {
      return direction == Direction.IN ? type.name() : "Out<" + type.boxed() + ">";
    }

    /** The variable's declaration as a parameter. */
    public String parameter() {
      return declared() + " " + local;
    }
  }

  /** A value of the case in a variable of its own. */
  public record Read(String local, JavaType type, String column) {}

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
   * An interface that is generated.
   *
   * @param role {@code required} or {@code provided}
   */
  public record Interface(String name, String source, String role, List<Signature> methods) {}

  /**
   * A method of an interface.
   *
   * @param returns null where it returns nothing
   * @param errors that it declares
   */
  public record Signature(
      String name,
      @Nullable JavaType returns,
      List<JavaParameter> parameters,
      List<String> errors) {
    public String returnName() {
      return returns == null ? "void" : returns.name();
    }
  }

  /** A parameter of an interface's method. */
  public record JavaParameter(String name, String local, JavaType type, Direction direction) {
    /** Its declaration. */
    public String declaration() {
      return (direction == Direction.IN ? type.name() : "Out<" + type.boxed() + ">") + " " + local;
    }
  }

  /**
   * A required interface, as the test stub implements it.
   *
   * @param field of the test stub
   */
  public record Stub(String name, String field, List<StubMethod> methods) {}

  /**
   * A method of a required interface.
   *
   * @param field of the test stub that answers for it
   * @param fullName {@code Interface.Method}
   * @param answered whether the suite sets its answers
   */
  public record StubMethod(
      Signature signature, String field, String fullName, boolean answered, List<StubOut> outs) {
    /** The type argument of what answers for it. */
    public String boxed() {
      return signature.returns() == null ? "Void" : signature.returns().boxed();
    }
  }

  /**
   * An out-parameter of a required method.
   *
   * @param field of the test stub that answers for it
   * @param fullName {@code Interface.Method.param}
   */
  public record StubOut(JavaParameter parameter, String field, String fullName, boolean answered) {}

  /**
   * What the suite answers with.
   *
   * @param local its variable, and the field of the test stub
   * @param column {@code Interface.Method} or {@code Interface.Method.param}
   * @param zero what is answered in its stead; {@code null} for a method that returns nothing
   */
  public record Answered(
      String local, String column, String boxed, String zero, Set<String> imports) {}

  /**
   * Something that is looked at after the call.
   *
   * @param expression that gives it, or the whole that it is part of; null where the method returns
   *     nothing, and all there is to see is that it returns
   * @param part whether it is a part of a whole
   * @param observed whether the world shows it
   */
  public record Output(String name, @Nullable String expression, boolean part, boolean observed) {}

  /** A call of the component, with arguments as expressions. */
  public record Call(String method, List<String> arguments, Set<String> imports) {}

  /** The return type as sources spell it. */
  public String returnName() {
    return returns == null ? "void" : returns.name();
  }

  /** Whether anything is observed in the world after the call. */
  public boolean observes() {
    return outputs.stream().anyMatch(Output::observed);
  }

  /** The answers that the suite sets, in the order of the stubs. */
  public List<Answered> answers() {
    List<Answered> answers = new java.util.ArrayList<>();
    for (Stub stub : stubs) {
      for (StubMethod method : stub.methods()) {
        JavaType type = method.signature().returns();
        if (method.answered()) {
          answers.add(
              new Answered(
                  method.field(),
                  method.fullName(),
                  method.boxed(),
                  type == null ? "null" : type.zero(),
                  type == null ? Set.of() : type.imports()));
        }
        for (StubOut out : method.outs()) {
          if (out.answered()) {
            JavaType held = out.parameter().type();
            answers.add(
                new Answered(
                    out.field(), out.fullName(), held.boxed(), held.zero(), held.imports()));
          }
        }
      }
    }
    return answers;
  }
}
