package org.sitaf.agent.sandbox;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * A process and all that it needs; whatever is not named here it need not have. The system's own
 * folders are always readable.
 *
 * @param working its working folder, writable, absolute; becomes {@code HOME}
 * @param temporary its folder for temporary files, writable, absolute
 * @param environment in addition to {@code PATH}, {@code HOME}, {@code TMPDIR}, {@code LANG}
 * @param readable files and folders beyond the system's, absolute
 * @param writable files and folders beyond the two above, absolute; they exist
 * @param network whether it reaches other machines; Unix sockets are files, and named as such
 * @param heldBack whether its input stays open until {@link ConfinedProcess#letGo}; else it is at
 *     its end from the beginning
 * @param channel a named pipe that the process finds open for writing as descriptor {@link
 *     #CHANNEL}; it need not see the file. Null for none
 */
public record Confinement(
    List<String> command,
    Path working,
    Path temporary,
    Map<String, String> environment,
    List<Path> readable,
    List<Path> writable,
    boolean network,
    boolean heldBack,
    @Nullable Path channel,
    ProcessLimits limits) {
  /** The descriptor behind the standard ones. */
  public static final int CHANNEL = 3;

  public Confinement {
    command = List.copyOf(command);
    Objects.requireNonNull(working);
    Objects.requireNonNull(temporary);
    environment = java.util.Collections.unmodifiableMap(new TreeMap<>(environment));
    readable = List.copyOf(readable);
    writable = List.copyOf(writable);
    Objects.requireNonNull(limits);
    if (command.isEmpty()) {
      throw new IllegalArgumentException("the command is empty");
    }
  }

  /** A command in a folder of its own, without environment, network or any further file. */
  public static Confinement of(
      List<String> command, Path working, Path temporary, ProcessLimits limits) {
    return new Confinement(
        command, working, temporary, Map.of(), List.of(), List.of(), false, false, null, limits);
  }

  /** With these variables too. */
  public Confinement withEnvironment(Map<String, String> more) {
    Map<String, String> all = new TreeMap<>(environment);
    all.putAll(more);
    return new Confinement(
        command, working, temporary, all, readable, writable, network, heldBack, channel, limits);
  }

  /** Reading these files and folders too. */
  public Confinement reading(List<Path> more) {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        joined(readable, more),
        writable,
        network,
        heldBack,
        channel,
        limits);
  }

  /** Writing these files and folders too. */
  public Confinement writing(List<Path> more) {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        joined(writable, more),
        network,
        heldBack,
        channel,
        limits);
  }

  /** Reaching other machines, as what fetches packages must. */
  public Confinement withNetwork() {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        writable,
        true,
        heldBack,
        channel,
        limits);
  }

  /** Waiting for a line on its input, as what is started before it has anything to do. */
  public Confinement heldBackUntilLetGo() {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        writable,
        network,
        true,
        channel,
        limits);
  }

  /** Writing to this named pipe too, by its descriptor alone. */
  public Confinement withChannel(Path pipe) {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        writable,
        network,
        heldBack,
        pipe,
        limits);
  }

  private static List<Path> joined(List<Path> some, List<Path> more) {
    List<Path> all = new ArrayList<>(some);
    all.addAll(more);
    return all;
  }
}
