package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.atomic.AtomicReference;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

/** The generation for any model ends: with the cases, or with an error that states the limit. */
@Tag("slow")
class GenerationLimitsTest {
  @Test
  void evaluatesTheOperandsOfAConjunctionSeparately() {
    TestSuite one =
        generate(six(10), "a == 1 && b == 2 && c == 3 && d == 4 && e == 5 && f == 6", "2");
    assertThat(one.cases())
        .extracting(TestCase::values)
        .containsExactly(List.of("1", "2", "3", "4", "5", "6"));

    TestSuite apart = generate(six(10), "a != b && b != c && (c != d && d < e) && e <= f", "2");
    assertThat(apart.cases()).hasSizeGreaterThanOrEqualTo(90);
    assertThat(apart.cases())
        .allSatisfy(
            c -> {
              assertThat(c.values().get(0)).isNotEqualTo(c.values().get(1));
              assertThat(c.values().get(1)).isNotEqualTo(c.values().get(2));
              assertThat(Integer.parseInt(c.values().get(3)))
                  .isLessThan(Integer.parseInt(c.values().get(4)));
            });
  }

  @Test
  void evaluatesAConjunctionAsAWholeIfAnOperandFails() {
    // If f is 0, the first operand is false, and the second one is not evaluated.
    TestSuite suite = generate(six(10), "f != 0 && 10 / f >= 2 && a < b && c < d && e < 9", "2");
    assertThat(suite.cases()).extracting(c -> c.values().get(5)).doesNotContain("0", "6", "9");
    assertThatThrownBy(() -> generate(six(10), "10 / f >= 2 && a < b && c < d && e < 9", "2"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("cannot be evaluated for");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "a + b + c + d + e + f == 20",
        "(a * 3 + b * 5 + c * 7 + d * 11 + e * 13 + f * 17) % 10 != 3 && a < 9"
      })
  void evaluatesOrRejectsAConditionThatCannotBeSplit(String condition) {
    try {
      assertThat(generate(six(10), condition, "2").cases()).isNotEmpty();
    } catch (InvalidInputException e) {
      assertThat(e)
          .hasMessageContaining("relates 6 parameters with 1,000,000 combinations")
          .hasMessageContaining("split it with &&");
    }
  }

  @Test
  void manyValuesOfAParameterNeedProportionalTimeAndMemory() {
    String inputs = random("a", 100_000) + listed("b", 3) + listed("c", 3);
    assertThat(generate(inputs, "", "2").cases()).hasSizeGreaterThanOrEqualTo(300_000);
    assertThatThrownBy(() -> generate(inputs, "a != c", "2"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("100000, more than the limit of 10000");
    assertThatThrownBy(() -> generate(random("a", 300_000), "", "1"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("has 300,000 values, but at most 200,000");
  }

  @Test
  void rejectsTooManyCasesBeforeTheGeneration() {
    assertThatThrownBy(() -> generate(listed("a", 3_000) + listed("b", 3_000), "", "2"))
        .hasMessageContaining("at least 9,000,000 cases")
        .hasMessageContaining("at most 1,000,000");
    assertThatThrownBy(() -> generate(six(11), "", "all"))
        .hasMessageContaining("at least 1,771,561 cases");
    String many =
        IntStream.range(0, 4_000).mapToObj(i -> listed("p" + i, 2)).collect(Collectors.joining());
    assertThatThrownBy(() -> generate(many, "", "2")).hasMessageContaining("parameter sets");
  }

  @Test
  void aTooExpensiveExpectedValueIsAnErrorAtTheFirstCase() {
    String expensive = "['ab']" + ".map(s, s + s)".repeat(30) + "[0] == '' ? 1 : 2";
    assertThatThrownBy(() -> generate(read(listed("a", 1_000), "", "1", expensive)))
        .isInstanceOfSatisfying(
            InvalidInputException.class,
            e -> {
              assertThat(e.diagnostics()).hasSize(1);
              assertThat(e.diagnostics().get(0).message())
                  .contains("case 1 ", "it creates a string of");
            });
  }

  @Test
  void rejectsTooLongTexts() {
    String text =
        "<test_element abstract_type=\"STRING\" real_type=\"string\"><name>t</name>"
            + "<type>TDI</type><test_spec type=\"RANDOM_STRING\" min_length=\"1000000\""
            + " max_length=\"1000000\" alphabet=\"true\"/></test_element>";
    assertThatThrownBy(() -> generate(text + listed("b", 300), "", "2"))
        .hasMessageContaining("characters, but at most 200,000,000 are allowed");
    assertThatThrownBy(() -> generate(listed("a", 2), "a in [" + "1, ".repeat(200_000) + "1]", "1"))
        .hasMessageContaining("characters in total, but at most 500,000");
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "a + b + c + d > 1", "a + b + c + d + e + f > 30"})
  void anInterruptEndsAGeneration(String condition) throws InterruptedException {
    TestModel model = read(six(10), condition, "4", "1");
    AtomicReference<Throwable> end = new AtomicReference<>();
    CountDownLatch begun = new CountDownLatch(1);
    Thread generating =
        new Thread(
            () -> {
              begun.countDown();
              try {
                TestCaseGenerator.generate(
                    model, new GenerationOptions(null, null, 1, Effort.BEST));
              } catch (CancellationException | InvalidInputException e) {
                end.set(e);
              }
            });
    generating.start();
    begun.await();
    generating.interrupt();
    generating.join();
    assertThat(end.get()).isInstanceOf(CancellationException.class);
  }

  private static TestSuite generate(String inputs, String condition, String order) {
    return generate(read(inputs, condition, order, "1"));
  }

  private static TestSuite generate(TestModel model) {
    return TestCaseGenerator.generate(model, new GenerationOptions(null, null, 1, Effort.FAST))
        .suite();
  }

  private static TestModel read(String inputs, String condition, String order, String expected) {
    String model =
        "<test_model><name>M</name>"
            + (condition.isEmpty()
                ? ""
                : "<pre_condition_spec_list><pre_condition><![CDATA["
                    + condition
                    + "]]></pre_condition></pre_condition_spec_list>")
            + "<input_spec_list>"
            + inputs
            + "</input_spec_list><output_spec_list><test_element abstract_type=\"NUMERIC\""
            + " real_type=\"int\"><name>return</name><type>RETURN</type><expected><![CDATA["
            + expected
            + "]]></expected></test_element></output_spec_list><order_of_combinations>"
            + order
            + "</order_of_combinations></test_model>";
    return TestModelXml.read(
        new ByteArrayInputStream(model.getBytes(StandardCharsets.UTF_8)), "m.xml");
  }

  private static String six(int values) {
    return "abcdef"
        .chars()
        .mapToObj(c -> listed(String.valueOf((char) c), values))
        .collect(Collectors.joining());
  }

  private static String listed(String name, int values) {
    return element(name)
        + IntStream.range(0, values)
            .mapToObj(i -> "<value>" + i + "</value>")
            .collect(Collectors.joining("", "<user_value_list>", "</user_value_list>"))
        + "</test_element>";
  }

  private static String random(String name, int values) {
    return element(name)
        + "<test_spec type=\"RANDOM\" count=\""
        + values
        + "\" min=\"0\" max=\"2000000000\"/></test_element>";
  }

  private static String element(String name) {
    return "<test_element abstract_type=\"NUMERIC\" real_type=\"int\"><name>"
        + name
        + "</name><type>TDI</type>";
  }
}
