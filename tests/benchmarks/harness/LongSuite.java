import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.function.UnaryOperator;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/** Long suites that repeat the cases of an example. */
final class LongSuite {
  private static final double FURTHEST = 10;

  private LongSuite() {}

  /** Repeats the cases up to the given number. */
  static UnaryOperator<TestSuite> repeated(int atLeast) {
    return suite -> {
      List<TestCase> cases = new ArrayList<>(suite.cases());
      while (cases.size() < atLeast) {
        TestCase again = cases.get(cases.size() % suite.cases().size());
        cases.add(again.withNumber(cases.size() + 1));
      }
      return suite.withCases(cases);
    };
  }

  /**
   * Repeats the valid cases with different distances, so that no world that was
   * prepared for one case can be reused.
   */
  static UnaryOperator<TestSuite> withDistinctDistances(int count) {
    return suite -> {
      List<TestCase> valid = suite.cases().stream().filter(TestCase::valid).toList();
      int place = suite.parameters().stream().map(CaseParameter::name).toList().indexOf("Distance");
      List<TestCase> cases = new ArrayList<>();
      for (int i = 0; i < count; i++) {
        TestCase model = valid.get(i % valid.size());
        String before = model.values().get(place);
        String distance = String.format(Locale.ROOT, "%.6f", i * FURTHEST / count);
        List<String> values = new ArrayList<>(model.values());
        values.set(place, distance);
        List<ExpectedValue> expected =
            model.expected().stream()
                .map(e -> e.literal().equals(before) ? new ExpectedValue(e.output(), distance) : e)
                .toList();
        cases.add(new TestCase(i + 1, true, values, expected));
      }
      return suite.withCases(cases);
    };
  }
}
