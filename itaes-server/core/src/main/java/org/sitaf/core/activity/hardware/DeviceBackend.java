package org.sitaf.core.activity.hardware;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;

/**
 * What serves a device of the world instead of, or next to, the simulation.
 *
 * @param kind never the simulation, which needs no entry
 * @param address gRPC target of a provider; null for a recording, and where an agent offers the
 *     device
 * @param maxAgeS the greatest age of a reading in seconds; 0 for a recording whose readings hold
 * @param file the recording in the activity; null for a real device
 * @param topic of an MCAP file; empty for other files
 * @param envelope smallest and largest value of the numbers in commands, narrower than the world's
 * @param rates greatest change per second of the numbers in commands
 * @param independentOf parameters of the world on which the readings do not depend
 * @param line in {@code activity.yaml}
 */
public record DeviceBackend(
    String device,
    Kind kind,
    @Nullable String address,
    double maxAgeS,
    @Nullable String file,
    String topic,
    Map<String, Range> envelope,
    Map<String, Double> rates,
    List<String> independentOf,
    int line) {
  /** The age of readings that an entry allows if it does not say. */
  public static final double DEFAULT_MAX_AGE_S = 0.1;

  /** A longer path cannot be a socket. */
  private static final Pattern SOCKET = Pattern.compile("unix:/[^\\s\\x00]{1,106}");

  private static final Pattern HOST = Pattern.compile("[A-Za-z0-9.-]{1,253}:[0-9]{1,5}");

  /** A name in a world. */
  private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]{0,127}");

  /** What an address must be, for messages. */
  public static final String ADDRESS_FORM = "unix:/PATH (at most 107 characters) or HOST:PORT";

  private static final String SHADOW_ERROR = ".shadow_error";

  public DeviceBackend {
    Objects.requireNonNull(device);
    Objects.requireNonNull(kind);
    Objects.requireNonNull(topic);
    envelope = Collections.unmodifiableMap(new TreeMap<>(envelope));
    rates = Collections.unmodifiableMap(new TreeMap<>(rates));
    independentOf = List.copyOf(independentOf);
  }

  /** Whether a real device is read. */
  public boolean isReal() {
    return kind != Kind.REPLAY;
  }

  /** Whether a text can be the name of a device. */
  public static boolean isName(String text) {
    return NAME.matcher(text).matches();
  }

  /** Whether a text is the address of a provider. */
  public static boolean isAddress(String text) {
    return SOCKET.matcher(text).matches() || HOST.matcher(text).matches();
  }

  /** The signals that differences between real and simulated readings are: one per shadow. */
  public static List<String> signals(List<DeviceBackend> backends) {
    return backends.stream()
        .filter(backend -> backend.kind() == Kind.SHADOW)
        .map(backend -> backend.device() + SHADOW_ERROR)
        .toList();
  }

  /** What serves a device. */
  public enum Kind {
    /** A real device instead of the simulated one. */
    PROVIDER,
    /** A real device next to the simulated one, which the component uses. */
    SHADOW,
    /** A recording instead of the simulated device. */
    REPLAY
  }

  /** Both inclusive. */
  public record Range(double min, double max) {}
}
