package org.sitaf.cli;

import java.io.BufferedOutputStream;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.cli.option.GenerationArguments;
import org.sitaf.cli.option.SuiteFormat;
import org.sitaf.cli.terminal.ProgressLine;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GeneratedSuite;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.suite.document.TestSuiteXml;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Generates test cases from a test model. */
@Command(
    name = "generate",
    description = "Generates the test cases of a test model. Exit code 2: the model is invalid.",
    mixinStandardHelpOptions = true)
final class GenerateCommand implements Callable<Integer> {
  private static final String PROFILE = "activity.yaml";

  @Spec private @Nullable CommandSpec spec;

  @Parameters(
      paramLabel = "MODEL.xml",
      description = "The test model, or the folder of an activity that has one model.")
  private Path model = Path.of("");

  @Option(
      names = {"-o", "--output"},
      paramLabel = "FILE",
      description = "Output file; default: standard output.")
  private @Nullable Path output;

  @Option(
      names = "--invalid",
      paramLabel = "isolate|combine",
      description = "How invalid values are combined; default: as in the model.")
  private @Nullable InvalidValues invalidValues;

  @Mixin private final GenerationArguments generation = new GenerationArguments();

  @Option(
      names = "--seed-cases",
      paramLabel = "FILE",
      description =
          "An earlier suite, whose cases keep their numbers; only missing combinations are"
              + " added.")
  private @Nullable Path earlier;

  @Option(
      names = "--format",
      paramLabel = "xml|csv|json",
      defaultValue = "xml",
      description = "Format of the cases (default: ${DEFAULT-VALUE}).")
  private SuiteFormat format = SuiteFormat.XML;

  @Override
  public Integer call() throws IOException {
    TestModel parsed = read();
    GeneratedSuite generated;
    try (ProgressLine progress = new ProgressLine(System.err)) {
      generated =
          TestCaseGenerator.generate(
              parsed,
              generation.options(invalidValues, earlierSuite()),
              (rows, share) ->
                  progress.detail(
                      "%s: %d cases, minimizing, %.0f %%"
                          .formatted(parsed.name(), rows, share * 100)));
    }
    CommandLine command = java.util.Objects.requireNonNull(spec).commandLine();
    Sitaf.print(generated.notes(), command.getErr());
    if (output == null) {
      OutputStream out = new BufferedOutputStream(System.out, 1 << 16);
      format.write(generated.suite(), out);
      out.flush();
    } else {
      try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(output))) {
        format.write(generated.suite(), out);
      } catch (java.nio.file.FileSystemException e) {
        throw InvalidInputException.of(
            output.toString(), "cannot be written: " + e.getClass().getSimpleName());
      }
      long valid = generated.suite().validCount();
      int total = generated.suite().cases().size();
      command
          .getErr()
          .println(
              total + " cases (" + valid + " valid, " + (total - valid) + " invalid) in " + output);
    }
    return 0;
  }

  private TestModel read() {
    if (!Files.isDirectory(model)) {
      return TestModelXml.read(new ByteArrayInputStream(UserFiles.file(model)), model.toString());
    }
    if (!Files.exists(model.resolve(PROFILE))) {
      throw InvalidInputException.of(
          model.toString(),
          "is a folder without " + PROFILE + "; name a test model, or the folder of an activity");
    }
    List<TestModel> models = Installation.read(UserFiles.folder(model)).models();
    if (models.size() != 1) {
      throw InvalidInputException.of(
          model.toString(),
          models.isEmpty()
              ? "names no test model in " + PROFILE
              : "has several test models; name one of "
                  + models.stream()
                      .map(m -> model.resolve(m.source()).toString())
                      .collect(Collectors.joining(", ")));
    }
    return models.get(0);
  }

  private @Nullable TestSuite earlierSuite() {
    return earlier == null
        ? null
        : TestSuiteXml.read(new ByteArrayInputStream(UserFiles.file(earlier)), earlier.toString());
  }
}
