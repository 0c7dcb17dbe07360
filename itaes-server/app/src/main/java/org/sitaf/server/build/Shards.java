package org.sitaf.server.build;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.server.file.StoredFiles;

/** Splits the cases of a test application into shards, and joins the shards' results. */
final class Shards {
  private Shards() {}

  /**
   * Splits an application into shards of nearly equal size, in the order of the cases; empty if
   * there is nothing to split.
   */
  static List<TestApplication> split(TestApplication application, int shards) {
    List<TestCase> cases = application.suite().cases();
    int count = Math.min(shards, cases.size());
    List<TestApplication> applications = new ArrayList<>();
    for (int i = 0; count > 1 && i < count; i++) {
      int from = (int) ((long) cases.size() * i / count);
      int to = (int) ((long) cases.size() * (i + 1) / count);
      applications.add(withCases(application, cases.subList(from, to)));
    }
    return applications;
  }

  /** The application with only these cases. */
  static TestApplication withCases(TestApplication application, List<TestCase> cases) {
    TestSuite suite = application.suite();
    return new TestApplication(
        application.activity(),
        application.model(),
        suite.withCases(cases),
        application.harness(),
        application.entryPoint());
  }

  /** Joins the results of all shards. */
  static TestResult join(TestApplication application, List<TestResult> shards) {
    List<CaseResult> cases = shards.stream().flatMap(shard -> shard.cases().stream()).toList();
    TestResult joined =
        new ResultAssembler(application.model(), application.suite())
            .assemble(cases, "no shard executed it", provenance(application, shards));
    return new TestResult(
        joined.name(),
        joined.provenance(),
        joined.summary(),
        joined.parameters(),
        joined.cases(),
        coverage(shards),
        shards.stream().flatMap(shard -> shard.suspicions().stream()).distinct().toList());
  }

  /**
   * Joins the coverage of the shards. Only the number of branches that a shard took is known, so
   * the maximum of the shards is a lower bound of what they took together.
   */
  private static @Nullable Coverage coverage(List<TestResult> shards) {
    Map<String, Map<Integer, Coverage.Line>> files = new TreeMap<>();
    for (TestResult shard : shards) {
      Coverage coverage = shard.coverage();
      if (coverage == null) {
        return null;
      }
      for (Coverage.File file : coverage.files()) {
        Map<Integer, Coverage.Line> lines =
            files.computeIfAbsent(file.path(), path -> new TreeMap<>());
        file.lines().forEach(line -> lines.merge(line.number(), line, Shards::merge));
      }
    }
    return new Coverage(
        files.entrySet().stream()
            .map(e -> new Coverage.File(e.getKey(), List.copyOf(e.getValue().values())))
            .toList());
  }

  private static Coverage.Line merge(Coverage.Line one, Coverage.Line other) {
    return new Coverage.Line(
        one.number(),
        one.reached() || other.reached(),
        Math.max(one.branches(), other.branches()),
        Math.max(one.taken(), other.taken()));
  }

  private static Provenance provenance(TestApplication application, List<TestResult> shards) {
    List<Provenance> all = shards.stream().map(TestResult::provenance).toList();
    Provenance first = all.get(0);
    return new Provenance(
        StoredFiles.sha256(application.files().content("suite.xml").orElseThrow()),
        first.seed(),
        first.harness(),
        first.component(),
        distinct(all.stream().map(Provenance::agent).toList()),
        distinct(all.stream().map(Provenance::bridge).toList()),
        distinct(all.stream().map(Provenance::compiler).toList()),
        all.stream().flatMap(p -> p.packages().stream()).distinct().sorted().toList(),
        all.stream().map(Provenance::started).min(String::compareTo).orElse(""),
        all.stream().map(Provenance::finished).max(String::compareTo).orElse(""));
  }

  private static String distinct(List<String> names) {
    return String.join(", ", new TreeSet<>(names));
  }
}
