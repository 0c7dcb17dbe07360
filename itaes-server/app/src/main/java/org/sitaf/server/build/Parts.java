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

/** Spreads the cases of a test application over several, and puts their results together again. */
final class Parts {
  private Parts() {}

  /**
   * The application with a part of the cases each, in their order and of nearly equal size; none
   * where there is nothing to spread.
   */
  static List<TestApplication> split(TestApplication application, int parts) {
    List<TestCase> cases = application.suite().cases();
    int count = Math.min(parts, cases.size());
    List<TestApplication> applications = new ArrayList<>();
    for (int i = 0; count > 1 && i < count; i++) {
      int from = (int) ((long) cases.size() * i / count);
      int to = (int) ((long) cases.size() * (i + 1) / count);
      applications.add(withCases(application, cases.subList(from, to)));
    }
    return applications;
  }

  private static TestApplication withCases(TestApplication application, List<TestCase> cases) {
    TestSuite suite = application.suite();
    return new TestApplication(
        application.activity(),
        application.model(),
        new TestSuite(
            suite.name(),
            suite.description(),
            suite.modelName(),
            suite.generation(),
            suite.parameters(),
            cases),
        application.harness(),
        application.entryPoint());
  }

  /** One result of the whole application; each case has exactly one part that executed it. */
  static TestResult join(TestApplication application, List<TestResult> parts) {
    List<CaseResult> cases = parts.stream().flatMap(part -> part.cases().stream()).toList();
    TestResult joined =
        new ResultAssembler(application.model(), application.suite())
            .assemble(cases, "no shard executed it", provenance(application, parts));
    return new TestResult(
        joined.name(),
        joined.provenance(),
        joined.summary(),
        joined.parameters(),
        joined.cases(),
        coverage(parts),
        parts.stream().flatMap(part -> part.suspicions().stream()).distinct().toList());
  }

  /**
   * What any part reached. Of branches nobody says which were gone, only how many: the most that
   * one part went is the least that all together did.
   */
  private static @Nullable Coverage coverage(List<TestResult> parts) {
    Map<String, Map<Integer, Coverage.Line>> files = new TreeMap<>();
    for (TestResult part : parts) {
      Coverage coverage = part.coverage();
      if (coverage == null) {
        return null;
      }
      for (Coverage.File file : coverage.files()) {
        Map<Integer, Coverage.Line> lines =
            files.computeIfAbsent(file.path(), path -> new TreeMap<>());
        file.lines().forEach(line -> lines.merge(line.number(), line, Parts::together));
      }
    }
    return new Coverage(
        files.entrySet().stream()
            .map(e -> new Coverage.File(e.getKey(), List.copyOf(e.getValue().values())))
            .toList());
  }

  private static Coverage.Line together(Coverage.Line one, Coverage.Line other) {
    return new Coverage.Line(
        one.number(),
        one.reached() || other.reached(),
        Math.max(one.branches(), other.branches()),
        Math.max(one.taken(), other.taken()));
  }

  private static Provenance provenance(TestApplication application, List<TestResult> parts) {
    List<Provenance> all = parts.stream().map(TestResult::provenance).toList();
    Provenance first = all.get(0);
    return new Provenance(
        StoredFiles.sha256(application.files().content("suite.xml").orElseThrow()),
        first.seed(),
        first.harness(),
        first.component(),
        joined(all.stream().map(Provenance::agent).toList()),
        joined(all.stream().map(Provenance::bridge).toList()),
        all.stream().map(Provenance::started).min(String::compareTo).orElse(""),
        all.stream().map(Provenance::finished).max(String::compareTo).orElse(""));
  }

  private static String joined(List<String> names) {
    return String.join(", ", new TreeSet<>(names));
  }
}
