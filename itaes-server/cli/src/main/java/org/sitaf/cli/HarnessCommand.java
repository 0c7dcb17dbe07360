package org.sitaf.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.OpenOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.ActivityArguments;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCaseGenerator;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** Prints the sources of test applications, or generates an adapter. */
@Command(
    name = "harness",
    description =
        "Prints the sources of an activity's test applications: driver, stub, simulation control,"
            + " concrete driver, interfaces and types. Drivers that the activity keeps are ignored:"
            + " all sources are generated. Exit code 2:"
            + " the activity is invalid.",
    mixinStandardHelpOptions = true)
final class HarnessCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Mixin private final ActivityArguments arguments = new ActivityArguments();

  @Option(
      names = {"-o", "--output"},
      paramLabel = "DIR",
      description = "Output folder; default: print to standard output.")
  private @Nullable Path output;

  @Option(
      names = "--adapter",
      description =
          "Generates an adapter skeleton in the component's language instead: a class with every"
              + " method of the provided interfaces. It is written into the folder of the key adapter:"
              + " in the activity, or into DIR; existing files are not overwritten.")
  private boolean adapter;

  @Override
  public Integer call() throws IOException {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    if (adapter) {
      adapter(out);
      return 0;
    }
    Activity activity = Installation.read(UserFiles.folder(arguments.folder()));
    Map<String, byte[]> files = new HashMap<>();
    for (TestModel model : arguments.modelsOf(activity)) {
      FileTree harness =
          InterfaceTestApplicationGenerator.sources(
              activity,
              model,
              TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite());
      harness.paths().forEach(p -> files.put(p, harness.content(p).orElseThrow()));
    }
    FileTree sources = FileTree.of(files);
    if (output == null) {
      print(sources, out);
    } else {
      write(sources, output);
      out.println(sources.paths().size() + " files in " + output);
    }
    out.flush();
    return 0;
  }

  private void adapter(PrintWriter out) throws IOException {
    FileTree sources =
        InterfaceTestApplicationGenerator.adapter(
            Activity.readWithoutComponent(UserFiles.folder(arguments.folder())));
    Path below = output == null ? arguments.folder() : output;
    for (String path : sources.paths()) {
      if (Files.exists(below.resolve(path), LinkOption.NOFOLLOW_LINKS)) {
        throw InvalidInputException.of(
            below.resolve(path).toString(),
            "exists and is not overwritten; choose another folder with -o");
      }
    }
    write(sources, below, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
    sources.paths().forEach(path -> out.println(Printable.line(below.resolve(path).toString())));
    out.flush();
  }

  private static void print(FileTree sources, PrintWriter out) {
    for (String path : sources.paths()) {
      out.println("==> " + path + " <==");
      sources.text(path).orElseThrow().lines().map(Printable::line).forEach(out::println);
      out.println();
    }
  }

  private static void write(FileTree sources, Path folder, OpenOption... options)
      throws IOException {
    for (String path : sources.paths()) {
      Path file = folder.resolve(path);
      Files.createDirectories(Objects.requireNonNull(file.getParent()));
      Files.write(file, sources.content(path).orElseThrow(), options);
    }
  }
}
