package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;

/** A C++ process that waits until a debugger traces it. */
record CppDebuggee(DebugPlace place, long pid, Path program) implements Debuggee {
  /** The runtime creates it when the process waits. */
  private static final String WAITING = "waiting";

  /** Ends the wait without a debugger. */
  private static final String CONTINUE = "continue";

  /** Folder of the user's files in debug information; see the compiler's options. */
  private static final String ACTIVITY = "activity";

  @Override
  public boolean isReady() {
    return Files.exists(place.folder().resolve(WAITING));
  }

  @Override
  public List<String> debugger() {
    List<String> command = new ArrayList<>();
    command.add(Tools.find("gdb").map(Path::toString).orElse("gdb"));
    // These would ask before the terminal shows why.
    command.addAll(
        List.of("-q", "-iex", "set debuginfod enabled off", "-iex", "set pagination off"));
    // gdb asks libthread_db about each thread that it meets, and stops with "Cannot find user-level
    // thread" when gRPC's pool ends the thread meanwhile.
    command.addAll(List.of("-iex", "set libthread-db-search-path /dev/null"));
    command.addAll(List.of("-p", Long.toString(pid)));
    command.addAll(List.of("-ex", "set breakpoint pending on", "-ex", sources()));
    for (String breakpoint : breakpoints()) {
      command.addAll(List.of("-ex", "break " + breakpoint));
    }
    command.addAll(List.of("-ex", "continue"));
    return command;
  }

  private String sources() {
    return "set substitute-path " + ACTIVITY + " " + place.order().activity();
  }

  private List<String> breakpoints() {
    return place.order().methods().stream()
        .map(method -> place.order().className() + "::" + method)
        .toList();
  }

  @Override
  public List<String> connection() {
    return List.of(
        "attach gdb or lldb to process " + pid + " (" + program + ")",
        "source map: " + ACTIVITY + " -> " + place.order().activity(),
        "breakpoint: " + String.join(", ", breakpoints()));
  }

  @Override
  public Path folder() {
    return place.folder();
  }

  @Override
  public void letContinue() {
    try {
      Files.createFile(place.folder().resolve(CONTINUE));
    } catch (FileAlreadyExistsException e) {
      // It was allowed before.
    } catch (IOException e) {
      throw new UncheckedIOException("the process cannot be released", e);
    }
  }
}
