package org.sitaf.runtime.stub;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sitaf.runtime.CannotRunException;
import org.sitaf.runtime.Out;
import org.sitaf.runtime.Stopwatch;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.ResultsFile;
import org.sitaf.runtime.suite.TestCase;

class StubbedMethodTest {
  private final Stopwatch stopwatch = new Stopwatch();
  private final Stubbing stubbing = new Stubbing(stopwatch, null);
  private final StubbedMethod<Double> range =
      new StubbedMethod<>(stubbing, "Finder.GetRange", 0.0, "index", "name");

  private static TestCase testCase(String... columnsAndValues) {
    Map<String, String> values = new LinkedHashMap<>();
    for (int i = 0; i < columnsAndValues.length; i += 2) {
      values.put(columnsAndValues[i], columnsAndValues[i + 1]);
    }
    return new TestCase(1, true, values);
  }

  private String resultLine() throws Exception {
    CaseResult result = new CaseResult(testCase());
    stubbing.writeTo(result);
    var file = java.nio.file.Files.createTempFile("results", ".xml");
    try (ResultsFile results = ResultsFile.create(file)) {
      results.save(result);
    }
    String line = java.nio.file.Files.readString(file);
    java.nio.file.Files.delete(file);
    return line;
  }

  @Test
  void repeatsTheLastAnswer() {
    range.answerWith(
        testCase("Finder.GetRange", "1.5", "Finder.GetRange#2", "NaN", "Finder.GetRange#4", "-2")
            .answers("Finder.GetRange", Double.class, 0.0));
    assertThat(range.call(1, "a")).isEqualTo(1.5);
    assertThat(range.call(1, "a")).isNaN();
    assertThat(range.call(1, "a")).isNaN();
    assertThat(range.call(1, "a")).isEqualTo(-2);
    assertThat(range.call(1, "a")).isEqualTo(-2);
  }

  @Test
  void returnsTheDefaultValueInCasesWithoutAnAnswer() {
    range.answerWith(testCase("Other", "5").answers("Finder.GetRange", Double.class, 0.0));
    assertThat(range.call(1, "a")).isZero();
  }

  @Test
  void countsADelayAsTimeInStubsAndThenReturnsTheValue() {
    range.answerWith(
        testCase("Finder.GetRange", "!delay:0.02 3", "Finder.GetRange#2", "!delay:0.001")
            .answers("Finder.GetRange", Double.class, 0.0));
    stopwatch.start();
    double value = range.call(1, "a");
    assertThat(range.call(1, "a")).isZero();
    stopwatch.stop();
    assertThat(value).isEqualTo(3);
    assertThat(stopwatch.stubMicros()).isGreaterThanOrEqualTo(21_000);
    assertThat(stopwatch.componentMicros()).isLessThan(stopwatch.stubMicros());
  }

  @Test
  void reportsAnErrorWithoutAGeneratedType() {
    range.answerWith(
        testCase("Finder.GetRange", "!error:NoEcho").answers("Finder.GetRange", Double.class, 0.0));
    assertThatThrownBy(() -> range.call(1, "a"))
        .isInstanceOf(CannotRunException.class)
        .hasMessageContaining("sitaf.interfaces.NoEcho");
  }

  @Test
  void recordsCallsInOrderUpToALimitAndCountsTheRest() throws Exception {
    for (int i = 0; i < StubCalls.MAX_RECORDED + 7; i++) {
      range.call(i, "<\"&\n");
    }
    String line = resultLine();
    assertThat(line)
        .contains(
            "<call method=\"Finder.GetRange\"><argument name=\"index\">0</argument>"
                + "<argument name=\"name\">&lt;&quot;&amp;&#10;</argument></call>")
        .contains("<argument name=\"index\">999</argument>")
        .doesNotContain("<argument name=\"index\">1000</argument>")
        .contains("<calls_left_out>7</calls_left_out>");
    stubbing.begin();
    assertThat(resultLine()).doesNotContain("<call");
  }

  @Test
  void outParametersHaveSeparateAnswers() {
    StubbedOut<Integer> age = new StubbedOut<>(0);
    age.answerWith(testCase("F.M.age", "7", "F.M.age#2", "8").answers("F.M.age", Integer.class, 0));
    Out<Integer> out = new Out<>();
    age.fill(out);
    assertThat(out.get()).isEqualTo(7);
    age.fill(out);
    assertThat(out.get()).isEqualTo(8);
  }
}
