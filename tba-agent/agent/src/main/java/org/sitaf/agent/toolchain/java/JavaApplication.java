package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.ProcessPlace;
import org.sitaf.agent.toolchain.debug.DebugPlace;
import org.sitaf.agent.toolchain.debug.Debuggee;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.verdict.Coverage;

/**
 * A test application on a JVM.
 *
 * @param classPath absolute paths of runtime, libraries, and last the folder of classes
 * @param early whether processes start before the folder of classes is filled, and wait for it
 * @param archive class data sharing archive of the runtime for a faster start; null for none
 * @param packages of the component, with those that they need
 * @param recording null if coverage is off
 */
record JavaApplication(
    List<Path> classPath,
    String mainClass,
    boolean early,
    @Nullable Path archive,
    List<ResolvedPackage> packages,
    @Nullable JavaCoverage recording)
    implements CompiledApplication {
  private static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));

  /** Main class of the runtime; its first argument is the main class of the test application. */
  private static final String EARLY_START = "org.sitaf.runtime.EarlyStart";

  /** Memory for metaspace, code, stacks and the garbage collector. */
  private static final int OVERHEAD_MIB = 256;

  /**
   * How HotSpot computes identity hash codes: per thread (its default), random, ascending, or from
   * the address.
   */
  private static final List<Integer> IDENTITY_HASHES = List.of(5, 0, 3, 1);

  JavaApplication {
    classPath = List.copyOf(classPath);
    packages = List.copyOf(packages);
  }

  @Override
  public List<String> command(ProcessPlace place) {
    List<String> command = new ArrayList<>();
    command.add(JAVA_HOME.resolve("bin").resolve("java").toString());
    command.add("-Xmx" + place.memoryMiB() + "m");
    // A suite ends before the optimizing compiler pays off; only start-up time matters.
    command.add("-XX:TieredStopAtLevel=1");
    command.add("-XX:+UseSerialGC");
    command.add("-Xshare:auto");
    if (archive != null) {
      command.add("-XX:SharedArchiveFile=" + archive);
      // The JVM silently ignores an archive of another Java version.
      command.add("-Xlog:cds=off");
      command.add("-Xlog:cds+dynamic=off");
    }
    if (place.variation() > 0) {
      command.add("-XX:+UnlockExperimentalVMOptions");
      command.add(
          "-XX:hashCode=" + IDENTITY_HASHES.get(place.variation() % IDENTITY_HASHES.size()));
    }
    command.add("-XX:-UsePerfData");
    command.add("-XX:-CreateCoredumpOnCrash");
    command.add("-XX:ErrorFile=" + place.temporary().resolve("hs_err.log"));
    command.add("-Djava.io.tmpdir=" + place.temporary());
    command.add("-Dfile.encoding=UTF-8");
    command.add("-Dsun.stdout.encoding=UTF-8");
    command.add("-Dsun.stderr.encoding=UTF-8");
    if (place.debugging() != null) {
      command.add(JavaDebuggee.option(place.debugging()));
    }
    if (recording != null && place.coverage() != null) {
      command.add(recording.flag(place.coverage()));
      // Makes the runtime save the record periodically, in case the process is killed.
      command.add("-Dsitaf.coverage=true");
    }
    command.add("-cp");
    command.add(
        classPath.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator)));
    if (place.debugging() != null) {
      command.addAll(JavaDebuggee.start(place.debugging()));
    }
    if (early) {
      command.add(EARLY_START);
    }
    command.add(mainClass);
    return command;
  }

  @Override
  public Debuggee debuggee(DebugPlace place, long pid) {
    return new JavaDebuggee(place, classPath);
  }

  @Override
  public List<Path> readable() {
    List<Path> readable = new ArrayList<>(classPath);
    readable.add(JAVA_HOME);
    if (archive != null) {
      readable.add(archive);
    }
    if (recording != null) {
      readable.add(recording.recorder());
    }
    return readable;
  }

  @Override
  public Optional<String> hangLocation(String stacks) {
    return ThreadDump.componentStack(stacks);
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
  public int overheadMiB() {
    return OVERHEAD_MIB;
  }
}
