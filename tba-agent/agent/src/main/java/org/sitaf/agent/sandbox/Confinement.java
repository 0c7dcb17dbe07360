package org.sitaf.agent.sandbox;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * A command and everything that it may access. The system's programs and libraries are always
 * readable.
 *
 * @param working its working folder, writable, absolute; becomes {@code HOME}
 * @param temporary its folder for temporary files, writable, absolute
 * @param environment in addition to {@code PATH}, {@code HOME}, {@code TMPDIR}, {@code LANG}
 * @param readable absolute paths of files and folders, in addition to the system's
 * @param writable absolute paths of existing files and folders, in addition to the two above
 * @param network whether it may connect to other machines; Unix sockets are files and listed as
 *     such
 * @param keepsInputOpen whether its input stays open until {@link ConfinedProcess#release};
 *     otherwise its input is empty
 * @param channel named pipe that the process finds open for writing as descriptor {@link #CHANNEL},
 *     without seeing the file; null for none
 */
public record Confinement(
    List<String> command,
    Path working,
    Path temporary,
    Map<String, String> environment,
    List<Path> readable,
    List<Path> writable,
    boolean network,
    boolean keepsInputOpen,
    @Nullable Path channel,
    ProcessLimits limits) {
  /** The first descriptor after the standard streams. */
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

  /** A command without environment, network or files beyond its two folders. */
  public static Confinement of(
      List<String> command, Path working, Path temporary, ProcessLimits limits) {
    return new Confinement(
        command, working, temporary, Map.of(), List.of(), List.of(), false, false, null, limits);
  }

  /** Adds variables of the environment. */
  public Confinement withEnvironment(Map<String, String> more) {
    Map<String, String> all = new TreeMap<>(environment);
    all.putAll(more);
    return new Confinement(
        command,
        working,
        temporary,
        all,
        readable,
        writable,
        network,
        keepsInputOpen,
        channel,
        limits);
  }

  /** Adds readable files and folders. */
  public Confinement reading(List<Path> more) {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        joined(readable, more),
        writable,
        network,
        keepsInputOpen,
        channel,
        limits);
  }

  /** Adds writable files and folders. */
  public Confinement writing(List<Path> more) {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        joined(writable, more),
        network,
        keepsInputOpen,
        channel,
        limits);
  }

  /** Allows connections to other machines, as downloads of packages need. */
  public Confinement withNetwork() {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        writable,
        true,
        keepsInputOpen,
        channel,
        limits);
  }

  /** Keeps the input open, for a process that is started before its work is known. */
  public Confinement withInputOpen() {
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

  /** Adds a named pipe, which the process can write by its descriptor only. */
  public Confinement withChannel(Path pipe) {
    return new Confinement(
        command,
        working,
        temporary,
        environment,
        readable,
        writable,
        network,
        keepsInputOpen,
        pipe,
        limits);
  }

  private static List<Path> joined(List<Path> some, List<Path> more) {
    List<Path> all = new ArrayList<>(some);
    all.addAll(more);
    return all;
  }
}
