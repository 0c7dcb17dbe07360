package org.sitaf.cli.run;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Stack;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.suite.CaseNumbers;
import picocli.CommandLine;
import picocli.CommandLine.Model.ArgSpec;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** Which cases of a suite are executed, and how often. */
public final class CaseOptions {
  @Option(
      names = "--case",
      paramLabel = "NUMBERS",
      converter = NumbersConverter.class,
      description = "Executes only these cases, such as 9,12-20; they keep their numbers.")
  @Nullable CaseNumbers numbers;

  @Option(
      names = "--failed",
      paramLabel = "RESULT.xml",
      arity = "0..1",
      parameterConsumer = ResultFile.class,
      description =
          "Executes only the cases that did not pass in a result; default: the last run of the"
              + " activity on this machine.")
  @Nullable Path failed;

  @Option(
      names = "--repeat",
      paramLabel = "N",
      converter = CountConverter.class,
      description =
          "Executes the cases N times, each time in new processes; each case gets its worst"
              + " verdict.")
  @Nullable Integer repeat;

  @Option(
      names = "--until-failure",
      description = "Repeats the cases until one does not pass, at most as often as --repeat says.")
  boolean untilFailure;

  /** Whether the cases are executed several times. */
  boolean areRepeated() {
    return repeat != null || untilFailure;
  }

  /** How often the cases are executed at most. */
  int runs() {
    return repeat != null ? repeat : untilFailure ? Integer.MAX_VALUE : 1;
  }

  /** Whether {@code --failed} refers to the last run. */
  boolean ofLastRun() {
    return failed != null && failed.toString().isEmpty();
  }

  public static final class NumbersConverter implements CommandLine.ITypeConverter<CaseNumbers> {
    @Override
    public CaseNumbers convert(String value) {
      try {
        return CaseNumbers.parse(value);
      } catch (IllegalArgumentException e) {
        throw new CommandLine.TypeConversionException(e.getMessage());
      }
    }
  }

  static final class CountConverter implements CommandLine.ITypeConverter<Integer> {
    @Override
    public Integer convert(String value) {
      try {
        int number = Integer.parseInt(value);
        if (number >= 1) {
          return number;
        }
      } catch (NumberFormatException e) {
        // Reported below.
      }
      throw new CommandLine.TypeConversionException(
          "must be a whole number from 1, not '" + value + "'");
    }
  }

  /** Takes the next argument as the result unless it is an option or the folder of an activity. */
  static final class ResultFile implements CommandLine.IParameterConsumer {
    @Override
    public void consumeParameters(Stack<String> arguments, ArgSpec option, CommandSpec command) {
      boolean given =
          !arguments.isEmpty()
              && !arguments.peek().startsWith("-")
              && !isActivity(Path.of(arguments.peek()));
      option.setValue(Path.of(given ? arguments.pop() : ""));
    }

    /** A folder of results has no profile. */
    private static boolean isActivity(Path path) {
      return Files.isDirectory(path) && Files.isRegularFile(path.resolve("activity.yaml"));
    }
  }
}
