package org.sitaf.cli.run;

import java.io.ByteArrayInputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.sitaf.cli.file.UserFiles;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseNumbers;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;

/**
 * Selects the cases that options name.
 *
 * @param last the results of the last runs
 * @param activity folder of the activity
 */
public record CaseSelection(CaseOptions options, LastResults last, Path activity) {
  /**
   * The models whose cases can be selected.
   *
   * @throws InvalidInputException if the options do not say which model is meant
   */
  List<TestModel> models(List<TestModel> all) {
    if (all.size() > 1 && options.numbers != null) {
      throw InvalidInputException.of(
          "--case " + options.numbers,
          "needs --model, since the activity has several: "
              + all.stream().map(TestModel::name).collect(Collectors.joining(", ")));
    }
    if (options.failed == null || options.ofLastRun()) {
      return all;
    }
    Path given = Path.of(String.valueOf(options.failed));
    boolean isFolder = Files.isDirectory(given);
    String name = isFolder ? "" : read(given).name();
    List<TestModel> of =
        all.stream()
            .filter(m -> isFolder ? Files.exists(fileOf(m)) : m.name().equals(name))
            .toList();
    if (of.isEmpty()) {
      throw InvalidInputException.of(
          given.toString(),
          (isFolder ? "has no result" : "is a result of the model " + name)
              + "; this run has "
              + all.stream().map(TestModel::name).collect(Collectors.joining(", ")));
    }
    return of;
  }

  /**
   * The suite with the selected cases only.
   *
   * @throws InvalidInputException if a number does not exist, or a result is of other cases
   */
  TestSuite of(TestModel model, TestSuite suite) {
    TestSuite selected = suite;
    if (options.numbers != null) {
      List<CaseNumbers.Range> missing = options.numbers.missing(suite);
      if (!missing.isEmpty()) {
        throw InvalidInputException.of(
            "--case " + missing.get(0),
            "does not exist; "
                + model.name()
                + " has "
                + suite.cases().size()
                + " cases, numbered "
                + suite.cases().stream().mapToInt(TestCase::no).min().orElse(0)
                + " to "
                + suite.cases().stream().mapToInt(TestCase::no).max().orElse(0));
      }
      selected = options.numbers.select(selected);
    }
    if (options.failed != null) {
      Optional<TestResult> result =
          options.ofLastRun() ? last.of(activity, model) : Optional.of(read(fileOf(model)));
      if (result.isEmpty()) {
        throw InvalidInputException.of(
            "--failed", "there is no earlier run of " + model.name() + " on this machine");
      }
      selected = CaseNumbers.of(failed(suite, result.get())).select(selected);
    }
    return selected;
  }

  /** The given result, or the one of the model in the folder that {@code --result} wrote. */
  private Path fileOf(TestModel model) {
    Path given = Path.of(String.valueOf(options.failed));
    return Files.isDirectory(given) ? given.resolve(model.name() + ".xml") : given;
  }

  private static TestResult read(Path file) {
    return TestResultXml.read(new ByteArrayInputStream(UserFiles.file(file)), file.toString());
  }

  private TreeSet<Integer> failed(TestSuite suite, TestResult result) {
    Map<Integer, TestCase> cases = new HashMap<>();
    suite.cases().forEach(c -> cases.put(c.no(), c));
    TreeSet<Integer> numbers = new TreeSet<>();
    for (CaseResult each : result.cases()) {
      TestCase testCase = cases.get(each.no());
      if (each.verdict() == Verdict.PASS) {
        continue;
      }
      if (testCase == null || !testCase.values().equals(each.values())) {
        throw InvalidInputException.of(
            "--failed " + options.failed,
            "case "
                + each.no()
                + " of the result has other values than in the suite; the model or an option"
                + " changed, so run the whole suite again");
      }
      numbers.add(each.no());
    }
    return numbers;
  }
}
