package org.sitaf.core.falsify;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.DoubleBinaryOperator;
import java.util.stream.LongStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.core.falsify.Falsification.Executor;
import org.sitaf.core.falsify.Falsification.Found;
import org.sitaf.core.falsify.Falsification.Outcome;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.GenerationOptions;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestCaseGenerator;

class FalsificationTest {
  private static final int BUDGET = 200;

  private static TestModel model(String a, String b) {
    String element =
        """
        <test_element abstract_type="NUMERIC" real_type="%s"><name>%s</name><type>%s</type>
          <test_spec type="BVA" offset="%s"><equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="-1"
            max="1"/></test_spec>
        </test_element>
        """;
    String xml =
        "<test_model><name>Settle</name><input_spec_list>"
            + element.formatted(a, "a", "TDI", offset(a))
            + element.formatted(b, "b", "TDSD", offset(b))
            + "</input_spec_list><output_spec_list/><order_of_combinations>2</order_of_combinations>"
            + "</test_model>";
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "Settle.xml");
  }

  private static String offset(String type) {
    return type.equals("int") ? "1" : "0.1";
  }

  private static List<List<Value>> covering(TestModel model) {
    return TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite().cases().stream()
        .filter(TestCase::valid)
        .map(
            c ->
                List.of(
                    Value.parse(c.values().get(0), model.inputs().get(0).type()),
                    Value.parse(c.values().get(1), model.inputs().get(1).type())))
        .toList();
  }

  private static double number(Value value) {
    return Double.parseDouble(value.literal());
  }

  /** Negative in a pocket that no boundary value meets; a basin around (-0.7, 1) misleads. */
  private static double margin(double a, double b) {
    double pocket = Math.exp(-(square(a - 0.55) + square(b - 0.3)) / 0.08);
    double basin = Math.exp(-(square(a + 0.7) + square(b - 1)) / 0.1);
    return 0.1 - 0.105 * pocket - 0.07 * basin;
  }

  private static double square(double x) {
    return x * x;
  }

  /** Low everywhere at the largest b, negative only in a narrow valley. */
  private static double valley(double a, double b) {
    double narrow = Math.exp(-square(a - 0.6) / 0.008) * Math.pow((b + 1) / 2, 6);
    return 0.035 + 0.01 * (1 - b) + 0.005 * square(a + 0.7) - 0.07 * narrow;
  }

  private static Executor executor() {
    return executor(FalsificationTest::margin);
  }

  private static Executor executor(DoubleBinaryOperator function) {
    return rows ->
        rows.stream()
            .map(
                row -> {
                  double margin = function.applyAsDouble(number(row.get(0)), number(row.get(1)));
                  return new Outcome(margin, margin < 0, "settles");
                })
            .toList();
  }

  @Tag("slow")
  @Test
  void findsAPocketFasterThanUniformRandomSearch() throws InterruptedException {
    TestModel model = model("double", "double");
    List<List<Value>> first = covering(model);
    assertThat(first)
        .allMatch(row -> margin(number(row.get(0)), number(row.get(1))) > 0, "the suite passes");
    List<Integer> searched = new ArrayList<>();
    List<Integer> drawn = new ArrayList<>();
    for (long seed : LongStream.rangeClosed(1, 10).toArray()) {
      Found found =
          new Falsification(SearchSpace.of(model, seed), BUDGET, seed, executor()).search(first);
      assertThat(found.outcome().violated()).as("seed " + seed).isTrue();
      assertThat(found.executions()).isLessThanOrEqualTo(BUDGET);
      searched.add(found.executions());
      Found random =
          new Falsification(SearchSpace.of(model, seed), 10_000, seed, executor())
              .searchUniformly(first);
      assertThat(random.outcome().violated()).as("random, seed " + seed).isTrue();
      drawn.add(random.executions());
    }
    assertThat(median(searched)).isLessThan(median(drawn));
  }

  @Test
  void leavesAFlatBasinForWhatIsUnknown() throws InterruptedException {
    TestModel model = model("double", "double");
    List<Integer> searched = new ArrayList<>();
    for (long seed : LongStream.rangeClosed(1, 10).toArray()) {
      Executor executor = executor(FalsificationTest::valley);
      searched.add(
          new Falsification(SearchSpace.of(model, seed), BUDGET, seed, executor)
              .search(covering(model))
              .executions());
    }
    assertThat(searched).allMatch(executions -> executions < BUDGET);
    assertThat(median(searched)).isLessThan(120);
  }

  private static double median(List<Integer> numbers) {
    int[] sorted = numbers.stream().mapToInt(Integer::intValue).sorted().toArray();
    return (sorted[sorted.length / 2] + sorted[(sorted.length - 1) / 2]) / 2.0;
  }

  @Test
  void theSameSeedGivesTheSameSearch() throws InterruptedException {
    TestModel model = model("double", "double");
    List<List<List<Value>>> batches = new ArrayList<>();
    for (int i = 0; i < 2; i++) {
      List<List<Value>> asked = new ArrayList<>();
      Executor executor =
          rows -> {
            asked.addAll(rows);
            return executor().execute(rows);
          };
      new Falsification(SearchSpace.of(model, 3), 80, 3, executor).search(covering(model));
      batches.add(asked);
    }
    assertThat(batches.get(0)).isEqualTo(batches.get(1));
  }

  @Test
  void staysInTheRangesAndEndsWhenWholeNumbersAreExhausted() throws InterruptedException {
    TestModel model = model("int", "int");
    SearchSpace space = SearchSpace.of(model, 1);
    assertThat(space.dimensions()).isEqualTo(2);
    List<List<Value>> executed = new ArrayList<>();
    Executor passing =
        rows -> {
          executed.addAll(rows);
          return rows.stream().map(row -> new Outcome(1, false, "settles")).toList();
        };
    Found found = new Falsification(space, BUDGET, 1, passing).search(covering(model));
    assertThat(found.outcome().violated()).isFalse();
    assertThat(found.executions()).isLessThanOrEqualTo(9).isEqualTo(executed.size());
    assertThat(executed)
        .allMatch(row -> Math.abs(number(row.get(0))) <= 1 && Math.abs(number(row.get(1))) <= 1);
  }

  @Test
  void uniformSearchCountsTheCasesUpToTheFirstViolation() throws InterruptedException {
    TestModel model = model("double", "double");
    List<List<Value>> executed = new ArrayList<>();
    Executor worseAndWorse =
        rows ->
            rows.stream()
                .map(
                    row -> {
                      executed.add(row);
                      return new Outcome(6 - executed.size(), executed.size() > 6, "settles");
                    })
                .toList();
    Found found =
        new Falsification(SearchSpace.of(model, 1), BUDGET, 1, worseAndWorse)
            .searchUniformly(covering(model));
    assertThat(found.executions()).isEqualTo(7);
    assertThat(found.row()).isEqualTo(executed.get(6));
  }

  @Test
  void casesThatCannotBeExecutedAreNotCounted() throws InterruptedException {
    TestModel model = model("double", "double");
    Executor none =
        rows -> Arrays.asList(new Outcome[rows.size()]).stream().map(o -> Outcome.NONE).toList();
    Found found = new Falsification(SearchSpace.of(model, 1), 30, 1, none).search(covering(model));
    assertThat(found.row()).isEmpty();
    assertThat(found.executions()).isZero();
  }
}
