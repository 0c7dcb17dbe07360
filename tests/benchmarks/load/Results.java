import java.io.ByteArrayOutputStream;
import java.util.List;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.core.verdict.Verdict;

/** Creates results like an agent. */
final class Results {
  private Results() {}

  /** A result of the suite in which each case passes. */
  static byte[] of(TestSuite suite) {
    List<CaseResult> cases =
        suite.cases().stream()
            .map(
                c -> {
                  List<NamedValue> values =
                      c.expected().stream().map(e -> new NamedValue(e.output(), e.literal())).toList();
                  var time = new CaseResult.ProcessingTime(100 + c.no(), 50, 0);
                  return new CaseResult(c.no(), Verdict.PASS, c.values(), values, values, time, "");
                })
            .toList();
    Provenance provenance =
        new Provenance("aa", 1, "bb", "cc", "load", "", "2026-01-01T00:00:00Z", "2026-01-01T00:00:01Z");
    Summary summary =
        new Summary(cases.size(), cases.size(), 0, 0, 0, 0, 0, new Summary.Times(101, 100 + cases.size(), 200, 10));
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    TestResultXml.write(new TestResult(suite.modelName(), provenance, summary, suite.parameters(), cases, null), document);
    return document.toByteArray();
  }
}
