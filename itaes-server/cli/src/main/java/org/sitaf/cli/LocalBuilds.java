package org.sitaf.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.Stream;
import org.sitaf.agent.build.BuildListener;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.build.BuildSettings;
import org.sitaf.agent.build.BuildStage;
import org.sitaf.agent.simulation.Simulator;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;

/** Builds on this machine, with a simulation of their own and nothing left behind. */
final class LocalBuilds implements AutoCloseable {
  private final Path directory;
  private final BuildSettings settings;
  private final AtomicInteger count = new AtomicInteger();

  LocalBuilds(Installation installation) throws IOException {
    directory = Files.createTempDirectory("sitaf-run-");
    settings =
        new BuildSettings(
            BuildSettings.runtimeJarsIn(installation.javaRuntime()),
            Simulator.started(installation.bridgeCommand(), directory.resolve("simulator")),
            Toolchains.find(),
            "");
  }

  /**
   * Generates the test application, compiles and executes it; says on standard error how far it is.
   */
  BuildOutcome run(Activity activity, TestModel model, TestSuite suite) {
    try (ProgressLine progress = new ProgressLine(System.err)) {
      progress.step(model.name() + ": generating the test application");
      TestApplication application =
          InterfaceTestApplicationGenerator.generate(activity, model, suite);
      BuildRun run =
          new BuildRun(
              application,
              directory.resolve("build-" + count.incrementAndGet()),
              settings,
              new Steps(model.name(), suite.cases().size(), progress));
      Thread onExit = new Thread(() -> run.cancel("the command was stopped"));
      Runtime.getRuntime().addShutdownHook(onExit);
      try {
        return run.run();
      } finally {
        removeHook(onExit);
      }
    }
  }

  @Override
  public void close() {
    settings.simulator().close();
    try (Stream<Path> files = Files.walk(directory)) {
      for (Path path : files.sorted(Comparator.reverseOrder()).toList()) {
        Files.delete(path);
      }
    } catch (IOException e) {
      throw new UncheckedIOException("left behind: " + directory, e);
    }
  }

  private static void removeHook(Thread hook) {
    try {
      Runtime.getRuntime().removeShutdownHook(hook);
    } catch (IllegalStateException e) {
      // The process is ending, and the hook with it.
    }
  }

  private record Steps(String model, int total, ProgressLine progress, AtomicInteger done)
      implements BuildListener {
    Steps(String model, int total, ProgressLine progress) {
      this(model, total, progress, new AtomicInteger());
    }

    @Override
    public void stage(BuildStage stage) {
      progress.step(
          model
              + switch (stage) {
                case PREPARING -> ": preparing the simulation";
                case COMPILING -> ": compiling";
                case RUNNING -> ": running " + total + " cases";
              });
    }

    @Override
    public void log(byte[] utf8) {
      // A person at a shell wants verdicts; what the component prints is in the messages of its
      // errors.
    }

    @Override
    public void caseFinished(CaseResult result) {
      progress.detail(done.incrementAndGet() + "/" + total);
    }
  }
}
