package org.sitaf.cli.run;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.agent.spool.LeastRecentlyUsed;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.digest.Sha256;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;

/** The cases that did not pass in the last run of each model on this machine. */
public final class LastResults {
  private static final LeastRecentlyUsed BOUNDS = new LeastRecentlyUsed(64L << 20, 500);
  private static final String SUFFIX = ".result";

  private final Path folder;

  LastResults(Path folder) {
    this.folder = folder;
  }

  /** The cases of the last run that did not pass; empty if there was no run. */
  Optional<TestResult> of(Path activity, TestModel model) {
    Path file = file(activity, model);
    if (!Files.isRegularFile(file)) {
      return Optional.empty();
    }
    try (InputStream in = new BufferedInputStream(Files.newInputStream(file))) {
      return Optional.of(TestResultXml.read(in, file.getFileName().toString()));
    } catch (IOException | InvalidInputException | IllegalArgumentException e) {
      return Optional.empty();
    }
  }

  /**
   * Keeps the cases of a run that did not pass. A folder that cannot be written is no error.
   *
   * @param whole whether the run executed the whole suite; otherwise the earlier cases remain that
   *     it did not execute
   */
  void keep(Path activity, TestModel model, TestResult result, boolean whole) {
    List<CaseResult> cases = new ArrayList<>();
    if (!whole) {
      Set<Integer> executed =
          result.cases().stream()
              .map(CaseResult::no)
              .collect(Collectors.toCollection(HashSet::new));
      of(activity, model)
          .ifPresent(
              earlier ->
                  earlier.cases().stream()
                      .filter(c -> !executed.contains(c.no()))
                      .forEach(cases::add));
    }
    result.cases().stream().filter(c -> c.verdict() != Verdict.PASS).forEach(cases::add);
    Summary summary =
        new Summary(
            cases.size(),
            0,
            count(cases, Verdict.FAIL),
            count(cases, Verdict.ERROR),
            count(cases, Verdict.DONT),
            0,
            0,
            null);
    write(
        new TestResult(
            result.name(), result.provenance(), summary, result.parameters(), cases, null),
        file(activity, model));
  }

  private static int count(List<CaseResult> cases, Verdict verdict) {
    return (int) cases.stream().filter(c -> c.verdict() == verdict).count();
  }

  private void write(TestResult result, Path file) {
    try {
      Files.createDirectories(folder);
      Path temporary = Files.createTempFile(folder, "new", ".tmp");
      try {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(temporary))) {
          TestResultXml.write(result, out);
        }
        Files.move(temporary, file, StandardCopyOption.ATOMIC_MOVE);
      } finally {
        Files.deleteIfExists(temporary);
      }
      try (Stream<Path> files = Files.list(folder)) {
        BOUNDS.shrink(
            files.filter(f -> f.toString().endsWith(SUFFIX)).toList(),
            f -> f.toFile().length(),
            Files::deleteIfExists);
      }
    } catch (IOException | IllegalArgumentException e) {
      // --failed then needs the result file.
    }
  }

  private Path file(Path activity, TestModel model) {
    String name = activity.toAbsolutePath().normalize() + "\0" + model.name();
    return folder.resolve(Sha256.hex(name.getBytes(StandardCharsets.UTF_8)) + SUFFIX);
  }
}
