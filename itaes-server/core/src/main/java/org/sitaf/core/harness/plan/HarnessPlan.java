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
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.model.Value;

/**
 * A test application, decided: what is set, called, answered and looked at. Nothing in it is
 * spelled in a language yet; what a language cannot spell, its {@link HarnessWriter} says.
 *
 * <p>Names of methods, parameters, members and literals are words in some alphabet, so that no
 * other character of a user's reaches a source as a name; whether one is a keyword is for the
 * language to know. All other texts are the user's, and untrusted.
 *
 * @param description what the model says of itself
 * @param interfaceName the interface that declares the method under test
 * @param component class, properties, life cycle and period of the component under test
 * @param arguments in the order of the method's parameters
 * @param outputs what is looked at after the call, in the order of the results
 * @param world what the simulation sets; null where the activity names no world
 * @param stubs of the required interfaces
 * @param before calls that set the component up
 * @param provided the interfaces of the component, for what binds it to them
 * @param types structs and enumerations that the interfaces reach; what one is made of stands
 *     before it
 * @param errors names of exceptions that the interfaces declare or an answer raises, in order
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
    Limits limits) {
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
  }

  /**
   * A parameter of the method under test.
   *
   * @param given what the cases set in it: one {@link Given} without a path for the whole of it,
   *     several with paths for parts, none for an out-parameter that they leave alone. No path
   *     begins with another.
   */
  public record Argument(Parameter parameter, List<Given> given) {
    public Argument {
      Objects.requireNonNull(parameter);
      given = List.copyOf(given);
    }

    /** Its name in the interface. */
    public String name() {
      return parameter.name();
    }
  }

  /**
   * A value of the cases (TDI).
   *
   * @param column what the suite calls it
   * @param path where it goes within the parameter; empty for the whole
   * @param type that the interface has there
   */
  public record Given(String column, List<Step> path, DataType type) {
    public Given {
      Objects.requireNonNull(column);
      Objects.requireNonNull(type);
      path = List.copyOf(path);
    }
  }

  /**
   * The world of the activity and what the suite sets in it.
   *
   * @param path of its description, within the activity
   * @param settle simulation time before the call
   * @param runFor simulation time after it
   */
  public record World(String path, List<Setting> settings, Duration settle, Duration runFor) {
    public World {
      Objects.requireNonNull(path);
      Objects.requireNonNull(settle);
      Objects.requireNonNull(runFor);
      settings = List.copyOf(settings);
    }

    /**
     * A parameter of the world that the suite sets (TDSD), a number; the bounds are inclusive.
     *
     * @param name in the world, and what the suite calls it
     */
    public record Setting(String name, String unit, double min, double max) {
      public Setting {
        Objects.requireNonNull(name);
        Objects.requireNonNull(unit);
      }
    }
  }

  /**
   * A required interface.
   *
   * @param source name of the document that describes it
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
   * @param answers what the suite sets, by parameter, then by call; what it does not set has the
   *     zero of its type
   */
  public record StubMethod(Method method, List<Answer> answers) {
    public StubMethod {
      Objects.requireNonNull(method);
      answers = List.copyOf(answers);
    }
  }

  /**
   * An answer (TDTS), from one call on to the next that has its own.
   *
   * @param column what the suite calls it
   * @param parameter the out-parameter that it goes to; null for the return value
   * @param fromCall number of the first call that gets it, from 1
   * @param type that the interface has there
   * @param plain whether every value in the suite is one of the type: no {@code !error:NAME}, no
   *     {@code !delay:SECONDS}
   */
  public record Answer(
      String column, @Nullable Parameter parameter, int fromCall, DataType type, boolean plain) {
    public Answer {
      Objects.requireNonNull(column);
      Objects.requireNonNull(type);
      if (fromCall < 1) {
        throw new IllegalArgumentException("calls are counted from 1: " + fromCall);
      }
    }
  }

  /**
   * Something that is looked at after the call.
   *
   * @param name in the result
   */
  public record Output(String name, Source source, DataType type) {
    public Output {
      Objects.requireNonNull(name);
      Objects.requireNonNull(source);
      Objects.requireNonNull(type);
    }
  }

  /** Where an output comes from. */
  public sealed interface Source {
    /** The return value, or the part of it that the path leads to. */
    record Returned(List<Step> path) implements Source {
      public Returned {
        path = List.copyOf(path);
      }
    }

    /** An out-parameter, or the part of it that the path leads to. */
    record OutParameter(String parameter, List<Step> path) implements Source {
      public OutParameter {
        Objects.requireNonNull(parameter);
        path = List.copyOf(path);
      }
    }

    /** What the world shows, a number. */
    record Observation(String name) implements Source {}

    /** What the component last sent through an output data port, or the part the path leads to. */
    record DataPort(String port, List<Step> path) implements Source {
      public DataPort {
        Objects.requireNonNull(port);
        path = List.copyOf(path);
      }
    }

    /** The way into what is looked at; none for the whole of it. */
    default List<Step> path() {
      return List.of();
    }
  }

  /** A call of the component that sets it up; the values fit the types of the parameters. */
  public record Call(Method method, List<Value> arguments) {
    public Call {
      Objects.requireNonNull(method);
      arguments = List.copyOf(arguments);
    }
  }

  /**
   * What an adapter between a component and the interfaces of its test has to be.
   *
   * @param className as its language qualifies it
   * @param provided the interfaces that it implements
   * @param required names of the interfaces that it is given
   * @param hardware whether there is a world, the devices of which it is given
   */
  public record Adapter(
      String className,
      List<InterfaceDescription> provided,
      List<String> required,
      boolean hardware) {
    public Adapter {
      Objects.requireNonNull(className);
      provided = List.copyOf(provided);
      required = List.copyOf(required);
    }
  }

  /** The method under test as documents name it. */
  public String methodName() {
    return interfaceName + "." + method.name();
  }

  /** Whether the method under test returns nothing. */
  public boolean returnsNothing() {
    return isVoid(method.returnType());
  }

  /**
   * The name of a declared type without its scope: {@code Pose} of {@code geometry::Pose}, of
   * {@code geometry_msgs/Pose} and of {@code geometry.Pose}. No two {@link #types} share one.
   */
  public static String simpleName(DataType type) {
    return simpleName(type.spelling());
  }

  /** A name without its scope. */
  static String simpleName(String name) {
    return name.substring(
        Math.max(Math.max(name.lastIndexOf(':'), name.lastIndexOf('/')), name.lastIndexOf('.'))
            + 1);
  }

  /** Whether a type is {@code void}. */
  public static boolean isVoid(DataType type) {
    return type instanceof DataType.Scalar scalar && scalar.type() == ScalarType.VOID;
  }
}
