package org.sitaf.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** The sources of a test application, to read or to begin a concrete test driver with. */
@Command(
    name = "harness",
    description =
        "Shows the sources of an activity's test applications: driver, stub, simulation control,"
            + " concrete driver, and the interfaces and types that a component names. Exit code 2:"
            + " the activity cannot be used.",
    mixinStandardHelpOptions = true)
final class HarnessCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Parameters(paramLabel = "ACTIVITY_DIR", description = "Folder that holds activity.yaml.")
  private Path folder = Path.of("");

  @Option(
      names = "--model",
      paramLabel = "NAME",
      description = "The test model; without it, all of the activity.")
  private @Nullable String model;

  @Option(
      names = {"-o", "--output"},
      paramLabel = "DIR",
      description = "Folder that the sources are written into; without it, they are printed.")
  private @Nullable Path output;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    Activity activity = Activity.read(UserFiles.folder(folder));
    Map<String, byte[]> files = new HashMap<>();
    for (TestModel each : activity.models()) {
      if (model == null || each.name().equals(model)) {
        TestApplication application =
            InterfaceTestApplicationGenerator.generate(
                activity,
                each,
                TestCaseGenerator.generate(each, GenerationOptions.DEFAULT).suite());
        FileTree harness = application.harness();
        harness.paths().forEach(p -> files.put(p, harness.content(p).orElseThrow()));
      }
    }
    FileTree sources = FileTree.of(files);
    if (files.isEmpty()) {
      throw InvalidInputException.of(
          "--model",
          "there is no model "
              + model
              + "; there are "
              + activity.models().stream().map(TestModel::name).toList());
    }
    if (output == null) {
      print(sources, out);
    } else {
      write(sources, output);
      out.println(sources.paths().size() + " files in " + output);
    }
    out.flush();
    return 0;
  }

  private static void print(FileTree sources, PrintWriter out) {
    for (String path : sources.paths()) {
      out.println("==> " + path + " <==");
      sources.text(path).orElseThrow().lines().map(Printable::line).forEach(out::println);
      out.println();
    }
  }

  private static void write(FileTree sources, Path folder) throws IOException {
    for (String path : sources.paths()) {
      Path file = folder.resolve(path);
      Files.createDirectories(Objects.requireNonNull(file.getParent()));
      Files.write(file, sources.content(path).orElseThrow());
    }
  }
}
