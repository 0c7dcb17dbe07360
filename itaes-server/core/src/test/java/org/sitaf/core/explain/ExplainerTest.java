package org.sitaf.core.explain;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.explain.Explanation.Cause;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

class ExplainerTest {
  private static final int MAX_OF_BOUNDARY = 70;

  private static TestModel model(String conditions) {
    String range =
        "<test_element abstract_type='NUMERIC' real_type='%s'><name>%s</name><type>TDI</type>"
            + "<test_spec type='BVA' offset='%s'><equiv_class type='NEC_NUMERIC_TWO_BOUNDARY'"
            + " min='%s' max='%s'/></test_spec></test_element>";
    String document =
        "<test_model><name>M</name><target interface='I' method='m'/><input_spec_list>"
            + range.formatted("int", "A", "1", "1", "7")
            + range.formatted("int", "B", "1", "1", "7")
            + range.formatted("double", "X", "0.5", "0", "10")
            + "</input_spec_list>"
            + conditions
            + "<order_of_combinations>2</order_of_combinations></test_model>";
    return read(document);
  }

  private static TestModel read(String document) {
    return TestModelXml.read(new ByteArrayInputStream(document.getBytes(UTF_8)), "M.xml");
  }

  private static CaseResult result(TestCase testCase, Predicate<double[]> fails) {
    double[] values = testCase.values().stream().mapToDouble(Double::parseDouble).toArray();
    boolean failed = testCase.valid() && fails.test(values);
    return new CaseResult(
        testCase.no(),
        failed ? Verdict.FAIL : Verdict.PASS,
        testCase.values(),
        List.of(),
        List.of(),
        null,
        failed ? "expected " + values[2] + ", but was -1.0" : "");
  }

  private static Explanation explain(TestModel model, Predicate<double[]> fails)
      throws InterruptedException {
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    return new Explainer(
            model,
            suite,
            suite.cases().stream().map(c -> result(c, fails)).toList(),
            null,
            null,
            cases -> cases.stream().map(c -> result(c, fails)).toList(),
            500)
        .explain();
  }

  @Test
  void equalInputsAreOneRelation() throws InterruptedException {
    Explanation explanation = explain(model(""), v -> v[0] == v[1]);

    assertThat(explanation.causes()).hasSize(1);
    Cause cause = explanation.causes().get(0);
    assertThat(cause.relation()).isEqualTo("A == B");
    assertThat(cause.parameters()).isEmpty();
    assertThat(cause.cases()).hasSize(5);
    assertThat(cause.simplest()).containsEntry("X", "0.0");
    assertThat(explanation.executions()).isLessThanOrEqualTo(20);
    assertThat(explanation.unexplained()).isEmpty();
  }

  @Test
  void theSimplestCaseOfATupleHasZeroElsewhere() throws InterruptedException {
    Explanation explanation = explain(model(""), v -> v[0] == 4 && v[1] == 6);

    assertThat(explanation.causes()).hasSize(1);
    Cause cause = explanation.causes().get(0);
    assertThat(cause.parameters()).isEqualTo(Map.of("A", "4", "B", "6"));
    assertThat(cause.simplest()).isEqualTo(Map.of("A", "4", "B", "6", "X", "0.0"));
    assertThat(cause.message()).startsWith("expected 0.0");
  }

  /** Otherwise the sentence would show the error of one cause as the effect of another. */
  @Test
  void theSimplestCaseOfACauseHasNoOtherCause() throws InterruptedException {
    String input =
        "<test_element abstract_type='NUMERIC' real_type='int'><name>%s</name><type>TDI</type>"
            + "<user_value_list>%s</user_value_list></test_element>";
    String numbers = "<value>0</value><value>1</value><value>2</value><value>3</value>";
    TestModel model =
        read(
            "<test_model><name>M</name><target interface='I' method='m'/><input_spec_list>"
                + input.formatted("A", numbers)
                + input.formatted("B", "<value>0</value><value>1</value>")
                + input.formatted("C", numbers)
                + "</input_spec_list><order_of_combinations>2</order_of_combinations>"
                + "</test_model>");
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    java.util.function.Function<TestCase, CaseResult> run =
        c -> {
          int[] v = c.values().stream().mapToInt(Integer::parseInt).toArray();
          boolean error = v[0] == 2 && v[1] == 0;
          boolean wrong = v[0] == 2 && v[2] == 1;
          return new CaseResult(
              c.no(),
              error ? Verdict.ERROR : wrong ? Verdict.FAIL : Verdict.PASS,
              c.values(),
              List.of(),
              List.of(),
              null,
              error ? "ValueError" : wrong ? "expected 0, but was 1" : "");
        };
    Explanation explanation =
        new Explainer(
                model,
                suite,
                suite.cases().stream().map(run).toList(),
                null,
                null,
                cases -> cases.stream().map(run).toList(),
                500)
            .explain();

    assertThat(explanation.causes())
        .extracting(Cause::parameters, Cause::verdict)
        .containsExactlyInAnyOrder(
            org.assertj.core.groups.Tuple.tuple(Map.of("A", "2", "B", "0"), Verdict.ERROR),
            org.assertj.core.groups.Tuple.tuple(Map.of("A", "2", "C", "1"), Verdict.FAIL));
    assertThat(explanation.causes())
        .extracting(Cause::simplest)
        .containsExactlyInAnyOrder(
            Map.of("A", "2", "B", "0", "C", "0"), Map.of("A", "2", "B", "1", "C", "1"));
  }

  /** The case with X = 2.5, which is invalid, and N = 2 passes: no sum of X and N is a cause. */
  @Test
  void aRelationThatAPassingCaseFulfilsIsNoCause() throws InterruptedException {
    String list =
        "<test_element abstract_type='%s' real_type='%s'><name>%s</name><type>TDI</type>"
            + "<user_value_list>%s</user_value_list></test_element>";
    TestModel model =
        read(
            "<test_model><name>M</name><target interface='I' method='m'/><input_spec_list>"
                + "<test_element abstract_type='NUMERIC' real_type='double'><name>X</name>"
                + "<type>TDI</type><test_spec type='BVA' offset='0.5'>"
                + "<equiv_class type='NEC_NUMERIC_TWO_BOUNDARY' min='-2' max='2'/></test_spec>"
                + "</test_element>"
                + list.formatted(
                    "NUMERIC",
                    "int",
                    "N",
                    "<value>0</value><value>1</value><value>2</value><value>3</value>")
                + list.formatted("NUMERIC", "int", "F", "<value>0</value><value>1</value>")
                + list.formatted(
                    "NUMERIC", "int", "S", "<value>0</value><value>1</value><value>5</value>")
                + "</input_spec_list><order_of_combinations>2</order_of_combinations>"
                + "</test_model>");
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    java.util.function.Function<TestCase, CaseResult> run =
        c -> {
          boolean fails =
              Double.parseDouble(c.values().get(0)) >= -1.1 && c.values().get(1).equals("3");
          return new CaseResult(
              c.no(),
              fails ? Verdict.FAIL : Verdict.PASS,
              c.values(),
              List.of(),
              List.of(),
              null,
              fails ? "wrong" : "");
        };
    Explanation explanation =
        new Explainer(
                model,
                suite,
                suite.cases().stream().map(run).toList(),
                null,
                null,
                cases -> cases.stream().map(run).toList(),
                500)
            .explain();

    assertThat(explanation.causes()).extracting(Cause::relation).containsOnlyNulls();
    assertThat(explanation.causes())
        .extracting(Cause::parameters)
        .contains(
            Map.of("X", "0.0", "N", "3"),
            Map.of("X", "1.5", "N", "3"),
            Map.of("X", "2.0", "N", "3"));
    assertThat(explanation.unexplained()).isEmpty();
  }

  @Tag("slow")
  @Test
  void failuresByChanceHaveNoCause() throws InterruptedException {
    TestModel model = model("");
    TestSuite suite = TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
    int runs = 4;
    int found = 0;
    for (int seed = 0; seed < runs; seed++) {
      java.util.Random random = new java.util.Random(seed);
      Predicate<double[]> fails = v -> random.nextDouble() < 0.3;
      found +=
          new Explainer(
                  model,
                  suite,
                  suite.cases().stream().map(c -> result(c, fails)).toList(),
                  null,
                  null,
                  cases -> cases.stream().map(c -> result(c, fails)).toList(),
                  500)
              .explain()
              .causes()
              .size();
    }
    assertThat(found).isLessThanOrEqualTo(2);
  }

  @Tag("slow")
  @Test
  void theSimplestCaseKeepsPreConditions() throws InterruptedException {
    TestModel model =
        model(
            "<pre_condition_spec_list><pre_condition>!valid || A != 4 || X &gt; 1.0"
                + "</pre_condition></pre_condition_spec_list>");
    Explanation explanation = explain(model, v -> v[0] == 4 && v[1] == 6);

    Cause cause = explanation.causes().get(0);
    assertThat(cause.parameters()).containsEntry("B", "6");
    assertThat(Double.parseDouble(cause.simplest().get("X"))).isGreaterThan(1.0);
  }

  @ParameterizedTest
  @ValueSource(doubles = {0.3, 0.7123456789, 3.14159, 6.02214076, 9.75, 1e-12})
  void aThresholdIsBracketedToNeighbouringNumbers(double threshold) throws InterruptedException {
    Explanation explanation = explain(model(""), v -> v[2] > threshold);

    assertThat(explanation.causes()).isNotEmpty();
    for (Cause cause : explanation.causes()) {
      assertThat(cause.parameters()).containsOnlyKeys("X");
      Explanation.Boundary boundary = java.util.Objects.requireNonNull(cause.boundary());
      assertThat(Double.parseDouble(boundary.passes())).isEqualTo(threshold);
      assertThat(Double.parseDouble(boundary.fails())).isEqualTo(Math.nextUp(threshold));
    }
    int others = 6 * explanation.causes().size();
    assertThat(explanation.executions()).isLessThanOrEqualTo(MAX_OF_BOUNDARY + others);
  }

  /** The rows that two tuples cause happen to have the largest sums of two other inputs. */
  @Test
  void aSumThatOnlyFailingRowsOfTheSuiteExceedIsNoCause() throws InterruptedException {
    String input =
        "<test_element abstract_type='NUMERIC' real_type='int'><name>%s</name><type>TDI</type>"
            + "<user_value_list>%s</user_value_list></test_element>";
    int[][] values = {
      {15, 11, 0, 17}, {15, 8, 6}, {19, 11, 14, 18}, {2, 7, 3}, {15, 6}, {6, 15, 0}, {11, 2, 3}
    };
    StringBuilder inputs = new StringBuilder();
    for (int i = 0; i < values.length; i++) {
      StringBuilder list = new StringBuilder();
      for (int value : values[i]) {
        list.append("<value>").append(value).append("</value>");
      }
      inputs.append(input.formatted("p" + i, list));
    }
    TestModel model =
        read(
            "<test_model><name>M</name><target interface='I' method='m'/><input_spec_list>"
                + inputs
                + "</input_spec_list>"
                + "<order_of_combinations>2</order_of_combinations></test_model>");

    Explanation explanation =
        explain(
            model,
            v ->
                v[1] == 8 && v[3] == 3
                    || v[6] == 3
                    || v[3] == 2 && v[5] == 0
                    || v[0] == 11 && v[1] == 6);

    assertThat(explanation.causes()).allMatch(c -> c.relation() == null);
    assertThat(explanation.causes().stream().map(Cause::parameters))
        .containsExactlyInAnyOrder(
            Map.of("p1", "8", "p3", "3"),
            Map.of("p6", "3"),
            Map.of("p3", "2", "p5", "0"),
            Map.of("p0", "11", "p1", "6"));
  }

  /** Also cases with a large sum of A and X fail, but they are not all that fail. */
  @Test
  void twoThresholdsAreNoSum() throws InterruptedException {
    Explanation explanation = explain(model(""), v -> v[0] > 2 && v[2] > 4.2);

    assertThat(explanation.causes()).allMatch(c -> c.relation() == null);
    assertThat(explanation.causes()).hasSizeGreaterThan(3);
    assertThat(explanation.causes())
        .extracting(Cause::parameters)
        .allMatch(p -> p.keySet().equals(java.util.Set.of("A", "X")))
        .contains(Map.of("A", "7", "X", "5.0"), Map.of("A", "4", "X", "10.0"));
    assertThat(explanation.unexplained()).isEmpty();
  }

  /** An input value that fails every other time is no cause, and is not searched to the end. */
  @Test
  void failuresOfOneValueByChanceHaveNoCause() throws InterruptedException {
    int found = 0;
    for (int seed = 0; seed < 4; seed++) {
      java.util.Random random = new java.util.Random(seed);
      Explanation explanation = explain(model(""), v -> v[0] == 4 && random.nextBoolean());
      found += explanation.causes().size();
      assertThat(explanation.executions()).isLessThan(200);
    }
    assertThat(found).isLessThanOrEqualTo(1);
  }

  @Test
  void nothingIsExecutedIfNoCaseFailed() throws InterruptedException {
    assertThat(explain(model(""), v -> false)).isEqualTo(new Explanation(List.of(), 0, List.of()));
  }
}
