package org.sitaf.cli.describe;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.concurrent.Callable;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.Sitaf;
import org.sitaf.cli.terminal.Printable;
import org.sitaf.core.diagnostic.Diagnostic;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Prints parsed interfaces. */
@Command(
    name = "describe",
    description =
        "Prints parsed interfaces: what a component provides and requires, methods, parameters,"
            + " resolved types, and all errors. Reads OPRoS"
            + " profiles (.xml), OMG IDL, ROS 2 (.msg, .srv, .action) and protobuf. Exit code 2: a"
            + " file is invalid.",
    mixinStandardHelpOptions = true)
public final class DescribeCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Parameters(
      paramLabel = "FILE",
      arity = "1..*",
      description = "Interface files, folders or zip archives.")
  private List<Path> files = List.of();

  @Option(
      names = "-I",
      paramLabel = "FOLDER",
      description =
          "Searches included IDL files in this folder; may be repeated. Its files are read only as"
              + " far as they are included.")
  private List<Path> includes = List.of();

  @Override
  public Integer call() {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    boolean usable = true;
    List<Diagnostic> diagnostics = new ArrayList<>();
    for (InterfaceSources.Source source : InterfaceSources.read(files, includes)) {
      DescriptionText.of(source.result(), source::show)
          .forEach(line -> out.println(Printable.line(line)));
      diagnostics.addAll(source.diagnostics());
      usable &= !source.result().hasErrors();
    }
    out.flush();
    Sitaf.print(diagnostics, spec.commandLine().getErr());
    return usable ? 0 : Sitaf.UNUSABLE;
  }
}
