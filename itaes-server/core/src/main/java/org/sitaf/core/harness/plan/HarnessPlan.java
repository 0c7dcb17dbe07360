package org.sitaf.core.harness.plan;

import java.time.Duration;
import java.util.List;
import java.util.Objects;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.MemberPath.Step;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.fault.FaultName;
import org.sitaf.core.model.Value;

/**
 * The language-independent plan of a test application: what is set, called, answered and checked. A
 * {@link HarnessWriter} turns it into sources and reports what its language cannot express.
 *
 * <p>Names of methods, parameters, members and literals are identifiers ({@link Words#isWord}), so
 * they can be safely written to a source; a writer must check for keywords. All other texts are
 * untrusted.
 *
 * @param description description of the model
 * @param interfaceName the interface that declares the method under test
 * @param component class, properties, life cycle and period of the component under test
 * @param arguments arguments in the order of the method's parameters
 * @param outputs outputs in the order of the results
 * @param world null if the activity has no world
 * @param stubs stubs of the required interfaces
 * @param before calls that set up the component
 * @param provided interfaces of the component
 * @param types structs and enumerations of the interfaces, in the order of their dependencies
 * @param errors names of exceptions that the interfaces declare or an answer raises, sorted
 * @param watched output data ports whose values are recorded at each simulation step
 * @param sequence the steps, if a case is a sequence; then the method is that of the first call,
 *     and arguments and outputs are those of the {@link Sequence#calls}
 */
public record HarnessPlan(
    String modelName,
    String description,
    String interfaceName,
    Method method,
    Component component,
    List<Argument> arguments,
    List<Output> outputs,
    @Nullable World world,
    List<Stub> stubs,
    List<Call> before,
    List<InterfaceDescription> provided,
    List<DataType> types,
    List<String> errors,
    Limits limits,
    List<Output> watched,
    @Nullable Sequence sequence) {
  public HarnessPlan {
    Objects.requireNonNull(modelName);
    Objects.requireNonNull(description);
    Objects.requireNonNull(interfaceName);
    Objects.requireNonNull(method);
    Objects.requireNonNull(component);
    Objects.requireNonNull(limits);
    arguments = List.copyOf(arguments);
    outputs = List.copyOf(outputs);
    stubs = List.copyOf(stubs);
    before = List.copyOf(before);
    provided = List.copyOf(provided);
    types = List.copyOf(types);
    errors = List.copyOf(errors);
    watched = List.copyOf(watched);
  }

  /**
   * The steps of the cases.
   *
   * @param properties parameters of the suite that are properties or constructor arguments of the
   *     component
   * @param threads from how many threads the calls are made; with 1, only calls that overlap have
   *     threads of their own
   */
  public record Sequence(
      List<CallStep> calls, List<EventStep> events, List<Given> properties, int threads) {
    public Sequence {
      calls = List.copyOf(calls);
      events = List.copyOf(events);
      properties = List.copyOf(properties);
    }

    /** The calls during which the next step begins. */
    public List<String> overlapping() {
      return calls.stream().filter(c -> c.overlap() || threads > 1).map(CallStep::name).toList();
    }
  }

  /**
   * A call as a step.
   *
   * @param call the plan of its method, arguments, outputs and times, of the parameters of the
   *     world that it sets before the call, and of the answers of stubs from then on. It has no
   *     stubs if it sets no answers
   * @param overlap whether the next step begins while the call runs
   */
  public record CallStep(String name, HarnessPlan call, boolean overlap) {
    public CallStep {
      Objects.requireNonNull(name);
      Objects.requireNonNull(call);
    }

    /** Simulation time before the call. */
    public Duration settle() {
      return call.world() == null ? Duration.ZERO : call.world().settle();
    }
  }

  /**
   * An event as a step.
   *
   * @param parameter parameter of the world, or fault of a device
   * @param value in the unit of the parameter
   */
  public record EventStep(String name, String parameter, double value) {
    public EventStep {
      Objects.requireNonNull(name);
      Objects.requireNonNull(parameter);
    }
  }

  /**
   * A parameter of the method under test.
   *
   * @param given the values that the cases set: one {@link Given} without a path for the whole
   *     parameter, several with paths for parts, none for an out-parameter without a value. No path
   *     is a prefix of another.
   */
  public record Argument(Parameter parameter, List<Given> given) {
    public Argument {
      Objects.requireNonNull(parameter);
      given = List.copyOf(given);
    }

    /** The name of the parameter in the interface. */
    public String name() {
      return parameter.name();
    }
  }

  /**
   * A value of the cases (TDI).
   *
   * @param column name of the suite's parameter
   * @param path path in the parameter; empty for the whole parameter
   * @param type type of this path in the interface
   */
  public record Given(String column, List<Step> path, DataType type) {
    public Given {
      Objects.requireNonNull(column);
      Objects.requireNonNull(type);
      path = List.copyOf(path);
    }
  }

  /**
   * The world of the activity.
   *
   * @param path path of the world description in the activity
   * @param settings parameters that the suite sets
   * @param settle simulation time before the call
   * @param runFor simulation time after the call
   */
  public record World(String path, List<Setting> settings, Duration settle, Duration runFor) {
    public World {
      Objects.requireNonNull(path);
      Objects.requireNonNull(settle);
      Objects.requireNonNull(runFor);
      settings = List.copyOf(settings);
    }

    /**
     * A parameter of the world that the suite sets (TDSD), with inclusive bounds.
     *
     * @param name name in the world and in the suite
     */
    public record Setting(String name, String unit, double min, double max) {
      public Setting {
        Objects.requireNonNull(name);
        Objects.requireNonNull(unit);
      }

      /** Whether it sets a fault of a device instead of a parameter of the world. */
      public boolean isFault() {
        return FaultName.isFault(name);
      }
    }
  }

  /**
   * A required interface.
   *
   * @param source name of the document
   */
  public record Stub(String name, String source, List<StubMethod> methods) {
    public Stub {
      Objects.requireNonNull(name);
      Objects.requireNonNull(source);
      methods = List.copyOf(methods);
    }
  }

  /**
   * A method of a required interface.
   *
   * @param answers answers that the suite sets, by parameter, then by call; everything else is zero
   */
  public record StubMethod(Method method, List<Answer> answers) {
    public StubMethod {
      Objects.requireNonNull(method);
      answers = List.copyOf(answers);
    }
  }

  /**
   * An answer (TDTS). It is used from a call on until the next answer.
   *
   * @param column name of the suite's parameter
   * @param parameter out-parameter that is set; null for the return value
   * @param fromCall number of the first call with this answer, from 1
   * @param type type of the out-parameter or return value
   * @param plain whether all values in the suite are values of the type, not {@code !error:NAME} or
   *     {@code !delay:SECONDS}
   */
  public record Answer(
      String column, @Nullable Parameter parameter, int fromCall, DataType type, boolean plain) {
    public Answer {
      Objects.requireNonNull(column);
      Objects.requireNonNull(type);
      if (fromCall < 1) {
        throw new IllegalArgumentException("call numbers start at 1: " + fromCall);
      }
    }
  }

  /**
   * An output that is read after the call.
   *
   * @param name name in the result
   */
  public record Output(String name, Source source, DataType type) {
    public Output {
      Objects.requireNonNull(name);
      Objects.requireNonNull(source);
      Objects.requireNonNull(type);
    }
  }

  /** The source of an output. */
  public sealed interface Source {
    /** The return value or a part of it. */
    record Returned(List<Step> path) implements Source {
      public Returned {
        path = List.copyOf(path);
      }
    }

    /** An out-parameter or a part of it. */
    record OutParameter(String parameter, List<Step> path) implements Source {
      public OutParameter {
        Objects.requireNonNull(parameter);
        path = List.copyOf(path);
      }
    }

    /** An observation of the world, a number. */
    record Observation(String name) implements Source {}

    /** The last value that the component sent through an output data port, or a part of it. */
    record DataPort(String port, List<Step> path) implements Source {
      public DataPort {
        Objects.requireNonNull(port);
        path = List.copyOf(path);
      }
    }

    /** The path in the output; empty for the whole output. */
    default List<Step> path() {
      return List.of();
    }
  }

  /** A call that sets up the component. The values match the types of the parameters. */
  public record Call(Method method, List<Value> arguments) {
    public Call {
      Objects.requireNonNull(method);
      arguments = List.copyOf(arguments);
    }
  }

  /**
   * The plan of an adapter between a component and the interfaces of its test.
   *
   * @param className qualified class name in the syntax of the language
   * @param provided interfaces that the adapter implements
   * @param required names of interfaces that are passed to the adapter
   * @param hardware whether the devices of the world are passed to the adapter
   * @param answers whether the methods return zero values until they are written, as the skeleton
   *     of a component does; those of an adapter fail
   */
  public record Adapter(
      String className,
      List<InterfaceDescription> provided,
      List<String> required,
      boolean hardware,
      boolean answers) {
    public Adapter {
      Objects.requireNonNull(className);
      provided = List.copyOf(provided);
      required = List.copyOf(required);
    }
  }

  /** The method under test, such as {@code Interface.Method}. */
  public String methodName() {
    return interfaceName + "." + method.name();
  }

  /** Whether the method under test returns nothing. */
  public boolean returnsNothing() {
    return method.returnType().isVoid();
  }

  /**
   * The name of a declared type without its scope: {@code Pose} of {@code geometry::Pose}, of
   * {@code geometry_msgs/Pose} and of {@code geometry.Pose}. No two {@link #types} share one.
   */
  public static String simpleName(DataType type) {
    return simpleName(type.typeName());
  }

  /** A name without its scope. */
  static String simpleName(String name) {
    return name.substring(
        Math.max(Math.max(name.lastIndexOf(':'), name.lastIndexOf('/')), name.lastIndexOf('.'))
            + 1);
  }
}
