package org.sitaf.core.suite;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.InputStream;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sitaf.core.combine.Effort;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;
import org.sitaf.core.suite.document.TestSuiteXml;

/**
 * The evaluation of the paper (section 4, Table 2): its tool generated 60 cases; the optimal
 * numbers are 55 and 49.
 */
class PaperExampleTest {
  private static TestModel model() {
    InputStream document =
        PaperExampleTest.class.getResourceAsStream("/models/GetInfraredData.xml");
    return TestModelXml.read(document, "GetInfraredData.xml");
  }

  private static TestSuite generate(InvalidValues invalidValues, long seed) {
    return TestCaseGenerator.generate(
            model(), new GenerationOptions(null, invalidValues, seed, Effort.DEFAULT))
        .suite();
  }

  @Test
  void isolatedInvalidValuesGiveTheOptimumOf55Cases() {
    TestSuite suite = generate(InvalidValues.ISOLATE, 1);
    assertThat(suite.cases()).hasSize(55);
    assertThat(suite.validCount()).isEqualTo(25);
    assertThat(suite.name()).isEqualTo("GetInfraredData-2way");
  }

  @Test
  void combinedInvalidValuesGiveTheOptimumOf49Cases() {
    assertThat(generate(InvalidValues.COMBINE, 1).cases()).hasSize(49);
  }

  @Test
  void validCasesAreFirstAndNumberedFromOne() {
    List<TestCase> cases = generate(InvalidValues.ISOLATE, 1).cases();
    for (int i = 0; i < cases.size(); i++) {
      assertThat(cases.get(i).no()).isEqualTo(i + 1);
      assertThat(cases.get(i).valid()).isEqualTo(i < 25);
    }
  }

  @Test
  void noIsolatedCaseHasTwoInvalidValues() {
    Set<String> invalid = Set.of("0", "8", "-0.5", "10.5");
    for (TestCase testCase : generate(InvalidValues.ISOLATE, 1).cases()) {
      long count = testCase.values().stream().filter(invalid::contains).count();
      assertThat(count).isEqualTo(testCase.valid() ? 0 : 1);
    }
  }

  @Test
  void everyPairOfValidValuesIsInAValidCase() {
    Set<String> pairs = new HashSet<>();
    for (TestCase c : generate(InvalidValues.ISOLATE, 1).cases()) {
      if (c.valid()) {
        for (int i = 0; i < 3; i++) {
          for (int j = i + 1; j < 3; j++) {
            pairs.add(i + "=" + c.values().get(i) + "," + j + "=" + c.values().get(j));
          }
        }
      }
    }
    assertThat(pairs).hasSize(3 * 25);
  }

  @Test
  void theExpectedValueFollowsTable2() {
    for (TestCase c : generate(InvalidValues.ISOLATE, 1).cases()) {
      int index = Integer.parseInt(c.values().get(0));
      int count = Integer.parseInt(c.values().get(1));
      String expected = c.valid() && index <= count ? c.values().get(2) : "-1.0";
      assertThat(c.expected()).containsExactly(new ExpectedValue("", expected));
    }
  }

  @Test
  void theSameSeedGivesTheSameBytes() {
    assertThat(bytes(generate(InvalidValues.ISOLATE, 7)))
        .isEqualTo(bytes(generate(InvalidValues.ISOLATE, 7)));
  }

  @Test
  void readsAWrittenSuiteUnchanged() {
    TestSuite suite = generate(InvalidValues.ISOLATE, 1);
    TestSuite read = TestSuiteXml.read(new ByteArrayInputStream(bytes(suite)), "suite.xml");
    assertThat(read).isEqualTo(suite);
  }

  private static byte[] bytes(TestSuite suite) {
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    TestSuiteXml.write(suite, out);
    return out.toByteArray();
  }
}
