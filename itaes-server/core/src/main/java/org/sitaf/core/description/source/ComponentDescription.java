package org.sitaf.core.description.source;

import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.DataType;

/**
 * A component profile.
 *
 * @param version empty if the profile has none
 * @param source name of the document
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
    /** The component only answers calls. */
    record Passive() implements Execution {}

    /**
     * The component is executed periodically.
     *
     * @param period in milliseconds, greater than 0
     */
    record Periodic(long period) implements Execution {
      public Periodic {
        if (period <= 0) {
          throw new IllegalArgumentException("a period must be greater than 0 ms: " + period);
        }
      }
    }

    /** The profile states no execution type or an unknown one. */
    record Unspecified(String text) implements Execution {
      public Unspecified {
        Objects.requireNonNull(text);
      }
    }
  }

  /**
   * A property of the component.
   *
   * @param value default value as text; null if there is none
   */
  public record Property(String name, DataType type, @Nullable String value) {
    public Property {
      Objects.requireNonNull(name);
      Objects.requireNonNull(type);
    }

    /** The default value as text. */
    public Optional<String> defaultValue() {
      return Optional.ofNullable(value);
    }
  }

  /** A port that connects a component to others. */
  public sealed interface Port {
    /** The name of the port. */
    String name();

    /**
     * A service port.
     *
     * @param interfaceName {@code type_name} of the interface
     * @param provided whether the component provides the interface; otherwise it requires it
     * @param file file that defines the interface; empty if it was not found
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
     * A data port.
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
     * An event port.
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
