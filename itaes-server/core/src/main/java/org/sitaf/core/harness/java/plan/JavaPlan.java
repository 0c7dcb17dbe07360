package org.sitaf.core.harness.java.plan;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.Direction;

/**
 * The plan of a test application in Java. All names and types are valid in Java.
 *
 * @param packageName package of the driver
 * @param method the method under test, as {@code Interface.method}
 * @param description description of the model
 * @param component type of the component as written in sources
 * @param componentImport import of the component; null if the qualified name is used
 * @param suiteLife whether the component lives as long as the suite
 * @param notHooks methods of the component's interfaces that are not life-cycle hooks
 * @param period period of a periodic component; null for a passive one
 * @param nonblocking whether the call is made on a separate thread
 * @param arguments arguments in the order of the method's parameters
 * @param returns null if the method returns nothing
 * @param world null if the activity has no world
 * @param interfaces generated interfaces
 * @param stubs stubs of the required interfaces
 * @param outputs outputs that are read after the call
 * @param watched output data ports that are read at each simulation step
 * @param properties property values of the component by name
 * @param before calls that set up the component
 * @param types generated structs and enumerations
 * @param errors generated exceptions
 * @param callName name of the driver's method that makes the call
 * @param steps of a sequence; empty if a case is one call
 * @param caseProperties parameters of the suite that are properties of the component
 * @param overlapping steps during which the next one begins
 * @param threads from how many threads the steps are called
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
    boolean nonblocking,
    List<Argument> arguments,
    @Nullable JavaType returns,
    @Nullable World world,
    List<Interface> interfaces,
    List<Stub> stubs,
    List<Output> outputs,
    List<Output> watched,
    Map<String, String> properties,
    List<Call> before,
    List<JavaDeclaredType> types,
    List<String> errors,
    String callName,
    List<Step> steps,
    List<String> caseProperties,
    List<String> overlapping,
    int threads) {

  /**
   * A parameter of the method under test.
   *
   * @param name name in the interface
   * @param local name of the variable
   * @param reads values of parts that are read from the case
   * @param value value before the call; null for an out-parameter without a value
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

    /** The declaration of the variable as a parameter. */
    public String parameter() {
      return declared() + " " + local;
    }
  }

  /** A value of the case in its own variable. */
  public record Read(String local, JavaType type, String column) {}

  /** The world of the activity and the parameters that the suite sets. */
  public record World(String path, List<Setting> settings, Duration settle, Duration runFor) {
    /**
     * A parameter of the world that the suite sets (TDSD).
     *
     * @param documentation unit and range, safe for a comment
     * @param fault whether it is a fault of a device
     */
    public record Setting(String name, String local, String documentation, boolean fault) {}
  }

  /**
   * A generated interface.
   *
   * @param role {@code required} or {@code provided}
   */
  public record Interface(String name, String source, String role, List<Signature> methods) {}

  /**
   * A method of an interface.
   *
   * @param returns null if it returns nothing
   * @param errors declared exceptions
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

  /** A parameter of an interface method. */
  public record JavaParameter(String name, String local, JavaType type, Direction direction) {
    /** The declaration of the parameter. */
    public String declaration() {
      return (direction == Direction.IN ? type.name() : "Out<" + type.boxed() + ">") + " " + local;
    }
  }

  /**
   * A required interface that the test stub implements.
   *
   * @param field field of the test stub
   */
  public record Stub(String name, String field, List<StubMethod> methods) {}

  /**
   * A method of a required interface.
   *
   * @param field field of the test stub
   * @param fullName {@code Interface.Method}
   * @param answered whether the suite sets its answers
   */
  public record StubMethod(
      Signature signature, String field, String fullName, boolean answered, List<StubOut> outs) {
    /** The type argument of the stubbed method. */
    public String boxed() {
      return signature.returns() == null ? "Void" : signature.returns().boxed();
    }
  }

  /**
   * An out-parameter of a required method.
   *
   * @param field field of the test stub
   * @param fullName {@code Interface.Method.param}
   */
  public record StubOut(JavaParameter parameter, String field, String fullName, boolean answered) {}

  /**
   * An answer that the suite sets.
   *
   * @param local name of the variable and of the field of the test stub
   * @param column {@code Interface.Method} or {@code Interface.Method.param}
   * @param zero default answer; {@code null} for a method that returns nothing
   */
  public record Answered(
      String local, String column, String boxed, String zero, Set<String> imports) {}

  /**
   * An output that is read after the call.
   *
   * @param expression expression of the output, or of the whole that it is part of; null if the
   *     method returns nothing
   * @param part whether the output is a part of the expression
   * @param observed whether it is an observation of the world
   */
  public record Output(String name, @Nullable String expression, boolean part, boolean observed) {}

  /**
   * A step of a sequence.
   *
   * @param method name of the driver's method that executes it
   * @param prepare name of the test stub's method that sets the answers of a call
   * @param call the plan of a call; null for an event
   * @param parameter what an event sets; empty for a call
   * @param value of the parameter
   */
  public record Step(
      String name,
      String method,
      String prepare,
      @Nullable JavaPlan call,
      String parameter,
      double value) {}

  /** Whether a case is a sequence of steps. */
  public boolean isSequence() {
    return !steps.isEmpty();
  }

  /** The plans of the calls: those of a sequence, or this one. */
  public List<JavaPlan> calls() {
    List<JavaPlan> calls = new java.util.ArrayList<>();
    for (Step step : steps) {
      JavaPlan call = step.call();
      if (call != null) {
        calls.add(call);
      }
    }
    return steps.isEmpty() ? List.of(this) : calls;
  }

  /** A call of the component with arguments as expressions. */
  public record Call(String method, List<String> arguments, Set<String> imports) {}

  /** The return type as written in sources. */
  public String returnName() {
    return returns == null ? "void" : returns.name();
  }

  /** Whether there is an observation of the world. */
  public boolean observes() {
    return calls().stream().anyMatch(c -> c.outputs.stream().anyMatch(Output::observed));
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
