package org.sitaf.server.build;

import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
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
    return new ResultAssembler(application.model(), application.suite())
        .assemble(cases, "no shard executed it", provenance(application, parts));
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
