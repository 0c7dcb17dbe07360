package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

/** A suite of a changed model keeps existing cases, and numbers of cases are never reused. */
@Tag("slow")
class EarlierSuiteTest {
  private static TestModel model(String... elements) {
    return model("", List.of(elements));
  }

  private static TestModel model(String preConditions, List<String> elements) {
    StringBuilder all = new StringBuilder();
    for (String element : elements) {
      String[] parts = element.split(" ", 2);
      all.append(
          "<test_element abstract_type='NUMERIC' real_type='int'><name>%s</name><type>TDI</type>%s</test_element>"
              .formatted(parts[0], parts[1]));
    }
    String xml =
        "<test_model><name>M</name><input_spec_list>%s</input_spec_list>%s<order_of_combinations>2</order_of_combinations></test_model>"
            .formatted(all, preConditions);
    return TestModelXml.read(
        new ByteArrayInputStream(xml.getBytes(StandardCharsets.UTF_8)), "M.xml");
  }

  private static String values(int... values) {
    StringBuilder list = new StringBuilder("<user_value_list>");
    for (int value : values) {
      list.append("<value>").append(value).append("</value>");
    }
    return list.append("</user_value_list>").toString();
  }

  private static String range(int min, int max) {
    return "<test_spec type='BVA' offset='1'><equiv_class type='NEC_NUMERIC_TWO_BOUNDARY' min='%d' max='%d'/></test_spec>"
        .formatted(min, max);
  }

  private static GeneratedSuite after(TestModel model, TestSuite earlier) {
    return TestCaseGenerator.generate(
        model, new GenerationOptions(null, null, 1, Effort.DEFAULT, earlier));
  }

  private static TestSuite fresh(TestModel model) {
    return TestCaseGenerator.generate(model, GenerationOptions.DEFAULT).suite();
  }

  private static Map<Integer, TestCase> byNumber(TestSuite suite) {
    return suite.cases().stream().collect(Collectors.toMap(TestCase::no, Function.identity()));
  }

  @Test
  void theSameModelAddsNothing() {
    TestModel model = model("a " + range(1, 7), "b " + range(1, 7), "c " + range(0, 9));
    TestSuite suite = fresh(model);
    assertThat(after(model, suite).suite().cases()).isEqualTo(suite.cases());
  }

  @Test
  void aNewValueAddsMissingCombinationsOnlyAndKeepsNumbers() {
    TestSuite old =
        fresh(model("a " + values(1, 2, 3), "b " + values(1, 2, 3), "c " + values(1, 2, 3)));
    TestSuite extended =
        after(model("a " + values(1, 2, 3, 4), "b " + values(1, 2, 3), "c " + values(1, 2, 3)), old)
            .suite();
    Map<Integer, TestCase> cases = byNumber(extended);
    old.cases().forEach(c -> assertThat(cases.get(c.no()).values()).isEqualTo(c.values()));
    assertThat(extended.cases()).hasSize(9 + 3);
    assertThat(extended.cases().subList(9, 12))
        .allMatch(c -> c.no() > 9 && c.values().get(0).equals("4"));
  }

  @Test
  void aNewElementCompletesOldCasesWithNewNumbers() {
    TestSuite old = fresh(model("a " + values(1, 2), "b " + values(1, 2)));
    GeneratedSuite extended =
        after(model("a " + values(1, 2), "b " + values(1, 2), "c " + values(5, 6)), old);
    assertThat(extended.suite().cases()).hasSize(4).allMatch(c -> c.no() > 4);
    assertThat(extended.notes())
        .extracting(Diagnostic::message)
        .anyMatch(m -> m.startsWith("4 case(s) lack a value for a new element"));
  }

  @Test
  void dropsOnlyCasesThatViolateANewConditionAndDoesNotReuseTheirNumbers() {
    String[] elements = {"a " + values(1, 2, 3), "b " + values(1, 2, 3), "c " + values(1, 2)};
    TestSuite old = fresh(model(elements));
    String different =
        "<pre_condition_spec_list><pre_condition>a != b</pre_condition></pre_condition_spec_list>";
    GeneratedSuite changed = after(model(different, List.of(elements)), old);
    Map<Integer, TestCase> cases = byNumber(changed.suite());
    for (TestCase earlier : old.cases()) {
      boolean violated = earlier.values().get(0).equals(earlier.values().get(1));
      assertThat(cases.containsKey(earlier.no())).isEqualTo(!violated);
    }
    assertThat(changed.suite().cases())
        .noneMatch(c -> c.values().get(0).equals(c.values().get(1)))
        .extracting(c -> c.values().get(0) + c.values().get(2))
        .contains("11", "12", "21", "22", "31", "32");
    assertThat(changed.notes())
        .extracting(Diagnostic::message)
        .anyMatch(m -> m.matches("case \\d violates 'a != b' and is dropped.*"));
  }

  @Test
  void keepsManuallyExpectedValues() {
    TestModel model = model("a " + values(1, 2), "b " + values(1, 2));
    TestSuite old = fresh(model);
    List<TestCase> filled = new ArrayList<>(old.cases());
    TestCase first = filled.get(0);
    filled.set(
        0,
        new TestCase(
            first.no(), first.valid(), first.values(), List.of(new ExpectedValue("", "42"))));
    TestSuite edited =
        new TestSuite(
            old.name(),
            old.description(),
            old.modelName(),
            old.generation(),
            old.parameters(),
            filled);
    assertThat(byNumber(after(model, edited).suite()).get(first.no()).expected())
        .containsExactly(new ExpectedValue("", "42"));
  }

  @Test
  void isolatesInvalidValuesAmongKeptCases() {
    TestModel model = model("a " + range(1, 5), "b " + range(1, 5));
    TestSuite old = fresh(model);
    TestSuite kept =
        new TestSuite(
            old.name(),
            old.description(),
            old.modelName(),
            old.generation(),
            old.parameters(),
            old.cases().stream().filter(c -> c.no() % 3 == 0).toList());
    TestSuite extended = after(model, kept).suite();
    assertThat(extended.cases().size()).isEqualTo(old.cases().size());
    assertThat(extended.cases())
        .filteredOn(c -> !c.valid())
        .allMatch(
            c -> c.values().stream().filter(v -> v.equals("0") || v.equals("6")).count() == 1);
  }
}
