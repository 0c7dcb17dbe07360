package org.sitaf.cli;

import java.io.ByteArrayInputStream;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Objects;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.OprosReader;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.diagnostic.InvalidInputException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** An interface as it is understood. */
@Command(
    name = "describe",
    description =
        "Shows interfaces as they are understood: methods, parameters, resolved types."
            + " Exit code 2: a file cannot be used.",
    mixinStandardHelpOptions = true)
final class DescribeCommand implements Callable<Integer> {
  @Spec private @Nullable CommandSpec spec;

  @Parameters(paramLabel = "FILE", arity = "1..*", description = "Interface files.")
  private List<Path> files = List.of();

  @Override
  public Integer call() {
    PrintWriter out = Objects.requireNonNull(spec).commandLine().getOut();
    Diagnostics diagnostics = new Diagnostics();
    for (Path file : files) {
      try {
        OprosReader.read(
                new ByteArrayInputStream(UserFiles.file(file)), file.toString(), diagnostics)
            .forEach(i -> print(i, out));
      } catch (InvalidInputException e) {
        diagnostics.addAll(e.diagnostics());
      }
    }
    out.flush();
    Sitaf.print(diagnostics.all(), spec.commandLine().getErr());
    return diagnostics.hasErrors() ? Sitaf.UNUSABLE : 0;
  }

  private static void print(InterfaceDescription description, PrintWriter out) {
    out.println("interface " + description.name());
    for (Method method : description.methods()) {
      out.println(
          "  "
              + method.returnType().spelling()
              + " "
              + method.name()
              + method.parameters().stream()
                  .map(DescribeCommand::spelling)
                  .collect(Collectors.joining(", ", "(", ")"))
              + (method.callType() == CallType.NONBLOCKING ? " nonblocking" : ""));
    }
  }

  private static String spelling(Parameter parameter) {
    String direction =
        parameter.direction() == Direction.IN
            ? ""
            : parameter.direction().name().toLowerCase(Locale.ROOT) + " ";
    return direction + parameter.type().spelling() + " " + parameter.name();
  }
}
