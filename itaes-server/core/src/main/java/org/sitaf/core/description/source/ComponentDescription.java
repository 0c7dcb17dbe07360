package org.sitaf.core.description.source;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A component as its profile describes it.
 *
 * @param version empty where the profile has none
 * @param source name of the document it was read from
 */
public record ComponentDescription(
    String name,
    String version,
    String description,
    Execution execution,
    List<Property> properties,
    List<Port> ports,
    String source) {
  public ComponentDescription {
    Objects.requireNonNull(name);
    Objects.requireNonNull(version);
    Objects.requireNonNull(description);
    Objects.requireNonNull(execution);
    properties = List.copyOf(properties);
    ports = List.copyOf(ports);
    Objects.requireNonNull(source);
  }

  /** How a component is executed. */
  public sealed interface Execution {
    /** It only answers calls. */
    record Passive() implements Execution {}

    /**
     * It is executed again and again.
     *
     * @param period in milliseconds, above 0
     */
    record Periodic(long period) implements Execution {
      public Periodic {
        if (period <= 0) {
          throw new IllegalArgumentException("a period is above 0 ms: " + period);
        }
      }
    }

    /** The profile does not say, or says something else. */
    record Unstated(String spelling) implements Execution {
      public Unstated {
        Objects.requireNonNull(spelling);
      }
    }
  }

  /**
   * A setting of the component.
   *
   * @param value its default, as text; null where there is none
   */
  public record Property(String name, DataType type, @Nullable String value) {
    public Property {
      Objects.requireNonNull(name);
      Objects.requireNonNull(type);
    }

    /** Its default, as text. */
    public Optional<String> defaultValue() {
      return Optional.ofNullable(value);
    }
  }

  /** Where a component is connected to others. */
  public sealed interface Port {
    /** Its name. */
    String name();

    /**
     * An interface.
     *
     * @param interfaceName its {@code type_name}
     * @param provided whether the component offers it; otherwise it calls it
     * @param file where the interface was found; empty where it is missing
     */
    record Service(String name, String interfaceName, boolean provided, String file)
        implements Port {
      public Service {
        Objects.requireNonNull(name);
        Objects.requireNonNull(interfaceName);
        Objects.requireNonNull(file);
      }
    }

    /**
     * A stream of values.
     *
     * @param output whether the component sends; otherwise it receives
     */
    record Data(String name, DataType type, boolean output) implements Port {
      public Data {
        Objects.requireNonNull(name);
        Objects.requireNonNull(type);
      }
    }

    /**
     * Single events.
     *
     * @param output whether the component sends; otherwise it receives
     */
    record Event(String name, DataType type, boolean output) implements Port {
      public Event {
        Objects.requireNonNull(name);
        Objects.requireNonNull(type);
      }
    }
  }
}
