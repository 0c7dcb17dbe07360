package org.sitaf.cli.lock;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.compiler.TestApplicationCompiler;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.Folders;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.SandboxOption;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.PackageChanges;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Writes or verifies {@code activity.lock}. */
@Command(
    name = "lock",
    description = {
      "Writes activity.lock: the exact releases of the packages that the component uses, with their"
          + " SHA-256. Builds then use exactly these.",
      "If the file exists, the command downloads what it lists and verifies it; --update chooses the"
          + " releases again. Exit code 2: the packages cannot be used."
    },
    mixinStandardHelpOptions = true)
public final class LockCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Parameters(paramLabel = "ACTIVITY_DIR", description = "Folder of activity.yaml.")
  private Path folder = Path.of("");

  @Option(
      names = "--update",
      description = "Chooses the newest suitable releases and replaces activity.lock.")
  private boolean update;

  @Mixin private final SandboxOption sandbox = new SandboxOption();

  @Override
  public Integer call() throws IOException, InterruptedException {
    FileTree files = UserFiles.folder(folder);
    Activity activity = Installation.read(update ? open(files) : files);
    ActivityLock before = update ? earlier(files) : ActivityLock.of(files).orElse(null);
    ActivityLock now = new ActivityLock(resolved(activity), true);
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    Path file = folder.resolve(ActivityLock.FILE);
    if (before != null && !update) {
      out.println(Printable.line(file + " is up to date: " + count(now)));
    } else {
      write(file, now.text());
      PackageChanges.between(before == null ? List.of() : before.packages(), now.packages())
          .forEach(line -> out.println(Printable.line(line)));
      out.println(Printable.line(file + ": " + count(now)));
    }
    out.flush();
    return 0;
  }

  private static String count(ActivityLock lock) {
    int count = lock.packages().size();
    return count == 1 ? "1 package" : count + " packages";
  }

  /** The files with a lock that leaves everything open, also if theirs is invalid. */
  private static FileTree open(FileTree files) {
    return files.contains(ActivityLock.FILE)
        ? files.with(
            ActivityLock.FILE,
            new ActivityLock(List.of(), false).text().getBytes(StandardCharsets.UTF_8))
        : files;
  }

  /** The lock that is replaced; null if there is none, or an invalid one. */
  private static @Nullable ActivityLock earlier(FileTree files) {
    try {
      return ActivityLock.of(files).orElse(null);
    } catch (InvalidInputException e) {
      return null;
    }
  }

  private List<ResolvedPackage> resolved(Activity activity)
      throws IOException, InterruptedException {
    Installation installation = Installation.current();
    Language language = activity.profile().harness();
    if (language == Language.CPP) {
      throw InvalidInputException.of(
          folder.toString(),
          "is tested in C++, whose packages belong to the machine and cannot be locked; give"
              + " libraries as files in 'libraries:'");
    }
    if (activity.models().isEmpty()) {
      throw InvalidInputException.of(folder.toString(), "names no test model in activity.yaml");
    }
    TestModel model = activity.models().get(0);
    TestSuite suite =
        TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite().withCases(List.of());
    Toolchains toolchains =
        new Toolchains(new ToolchainPlaces(installation.runtimes(), installation.cache()));
    Toolchain toolchain =
        toolchains
            .of(language)
            .orElseThrow(() -> new IOException(toolchains.missingMessage(language)));
    Path temporary = Files.createTempDirectory("sitaf-lock-");
    try {
      Sandbox opened = sandbox.open();
      return new TestApplicationCompiler(toolchain, toolchains.compiled(), false, opened)
          .packages(InterfaceTestApplicationGenerator.generate(activity, model, suite), temporary);
    } catch (CompilationException e) {
      throw InvalidInputException.of(
          e.diagnostics().isEmpty() ? folder.toString() : e.diagnostics().get(0).file(),
          e.getMessage()
              + (e.diagnostics().isEmpty() ? "" : ": " + e.diagnostics().get(0).message()));
    } finally {
      toolchains.stop();
      Folders.delete(temporary);
    }
  }

  /** Replaces the file at once, so that no build reads half of it. */
  private static void write(Path file, String text) throws IOException {
    Path directory = Objects.requireNonNull(file.toAbsolutePath().getParent());
    Path draft = Files.createTempFile(directory, ".activity-", ".lock");
    try {
      Files.writeString(draft, text);
      Files.setPosixFilePermissions(draft, PosixFilePermissions.fromString("rw-r--r--"));
      Files.move(draft, file, StandardCopyOption.ATOMIC_MOVE);
    } finally {
      Files.deleteIfExists(draft);
    }
  }
}
