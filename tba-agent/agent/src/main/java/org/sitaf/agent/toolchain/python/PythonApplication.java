package org.sitaf.agent.toolchain.python;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.ProcessPlace;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;
import org.sitaf.agent.toolchain.python.environment.Environments;
import org.sitaf.agent.toolchain.sanitizer.SanitizerSettings;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.verdict.Coverage;

/**
 * A Python test application.
 *
 * @param environment holds the packages of the component and the runtime
 * @param path folders of modules
 * @param sources those that are copies of folders of the activity, with their paths there
 * @param entryPoint the module of the concrete test driver
 * @param prefixes folders of Python's own library
 * @param packages those of the environment
 * @param recording null if coverage is off
 * @param sanitizing null if no node of it is compiled with sanitizers
 * @param ros the installation that its node runs with; null for any other application
 */
record PythonApplication(
    Path environment,
    List<Path> path,
    Map<Path, String> sources,
    String entryPoint,
    List<Path> prefixes,
    List<ResolvedPackage> packages,
    @Nullable Recording recording,
    @Nullable NodeSanitizing sanitizing,
    @Nullable RosInstallation ros)
    implements CompiledApplication {

  /** Memory of the interpreter and gRPC. */
  private static final int OVERHEAD_MIB = 128;

  /** Memory of rclpy and of the middleware with its shared memory. */
  private static final int ROS_MIB = 256;

  private static final int FRAMES = 4;
  private static final Pattern FRAME = Pattern.compile("\\s*File \"(.+)\", line (\\d+) in (.+)");

  PythonApplication {
    path = List.copyOf(path);
    sources = Collections.unmodifiableMap(new LinkedHashMap<>(sources));
    packages = List.copyOf(packages);
    prefixes = List.copyOf(prefixes);
  }

  @Override
  public List<String> command(ProcessPlace place) {
    List<String> command = new ArrayList<>();
    if (sanitizing != null) {
      command.addAll(sanitizing.launcher());
    }
    command.add(Environments.python(environment).toString());
    command.add("-s");
    command.add("-P");
    if (recording != null && place.coverage() != null) {
      command.addAll(recording.recorder(place.coverage()));
    }
    command.addAll(List.of("-m", "sitaf_runtime", entryPoint));
    return command;
  }

  @Override
  public Map<String, String> environment(ProcessPlace place) {
    Map<String, String> environment = new HashMap<>(place.memoryFill());
    environment.putAll(place.debuggerVariables());
    environment.putAll(
        Map.of(
            // Not PYTHONPATH: the runtime decides when modules of the component are loaded.
            "SITAF_PYTHONPATH",
            path.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator)),
            // Unbuffered, so that a component's output is complete when it ends the process.
            "PYTHONUNBUFFERED",
            "1",
            "PYTHONDONTWRITEBYTECODE",
            "1",
            "PYTHONHASHSEED",
            Integer.toString(place.variation()),
            "PYTHONUTF8",
            "1"));
    Path coverage = place.coverage();
    if (recording != null && coverage != null) {
      environment.putAll(recording.environment(coverage));
    }
    if (sanitizing != null) {
      environment.putAll(sanitizing.environment(place));
    }
    if (ros != null) {
      environment.putAll(ros.environment());
    }
    return environment;
  }

  @Override
  public Debuggee debuggee(DebugPlace place, long pid) {
    return new PythonDebuggee(place, Environments.python(environment), sources);
  }

  @Override
  public List<Path> readable() {
    List<Path> readable = new ArrayList<>(path);
    readable.add(environment);
    readable.addAll(prefixes);
    if (ros != null) {
      readable.addAll(ros.readable());
    }
    return readable;
  }

  @Override
  public Optional<String> hangLocation(String stacks) {
    List<String> frames = new ArrayList<>();
    for (String line : stacks.lines().toList()) {
      Matcher frame = FRAME.matcher(line);
      if (!frame.matches()) {
        continue;
      }
      Optional<Path> root =
          path.stream().filter(p -> frame.group(1).startsWith(p + "/")).findFirst();
      boolean ours = frame.group(1).contains("/sitaf_harness/");
      if (root.isPresent() && !ours) {
        frames.add(
            frame.group(3)
                + " ("
                + root.get().relativize(Path.of(frame.group(1)))
                + ":"
                + frame.group(2)
                + ")");
      }
    }
    return frames.isEmpty()
        ? Optional.empty()
        : Optional.of(String.join(", ", frames.subList(0, Math.min(FRAMES, frames.size()))));
  }

  @Override
  public boolean recordsCoverage() {
    return recording != null;
  }

  @Override
  public Optional<Coverage> coverage(Path data) throws IOException, InterruptedException {
    return recording == null ? Optional.empty() : Optional.of(recording.read(data));
  }

  @Override
  public boolean reservesMemory() {
    return sanitizing != null;
  }

  @Override
  public int overheadMiB() {
    return OVERHEAD_MIB
        + (sanitizing == null ? 0 : SanitizerSettings.MEMORY_MIB)
        + (ros == null ? 0 : ROS_MIB);
  }
}
