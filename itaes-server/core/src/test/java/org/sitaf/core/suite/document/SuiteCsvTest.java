package org.sitaf.core.suite.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

class SuiteCsvTest {
  private static final TestSuite SUITE =
      new TestSuite(
          "m-2way",
          "",
          "m",
          new Generation(new Strength(2), InvalidValues.ISOLATE, 1, "default", "test"),
          List.of(
              new CaseParameter("Name", InputKind.TDI, "string"),
              new CaseParameter("Distance", InputKind.TDSD, "double")),
          List.of(
              new TestCase(1, true, List.of("a, \"b\"\nc", "1.5"), expected("2.0")),
              new TestCase(2, false, List.of("\"", "-0.5"), List.of()),
              new TestCase(7, true, List.of(" ", "0.0"), expected("a\r\nb"))));

  @Test
  void whatWasWrittenIsReadAgainWhateverTheTextsHold() throws IOException {
    ByteArrayOutputStream csv = new ByteArrayOutputStream();
    SuiteCsv.write(SUITE, csv);
    TestSuite read =
        SuiteCsv.read(
            new ByteArrayInputStream(csv.toByteArray()), "cases.csv", SUITE.withCases(List.of()));
    assertThat(read).isEqualTo(SUITE);
  }

  @Test
  void everyLineThatIsNoCaseIsToldWithItsNumber() {
    String csv =
        "no,class,Name,Distance,expected\r\n1,valid,a,1.5,2.0\r\nx,valid,a,1.5,\r\n3,perhaps,a,1.5,\r\n4,valid,a\r\n";
    assertThatThrownBy(() -> read(csv))
        .isInstanceOfSatisfying(
            InvalidInputException.class,
            e -> assertThat(e.diagnostics()).extracting(d -> d.line()).containsExactly(3, 4, 5));
  }

  @Test
  void casesOfOtherParametersAreRefused() {
    assertThatThrownBy(() -> read("no,class,Other,Distance,expected\r\n1,valid,a,1.5,2.0\r\n"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("no,class,Name,Distance");
    assertThatThrownBy(() -> read("no,class,Name,Distance\n1,valid,a,1\n1,valid,b,1\n"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("used twice");
  }

  private static TestSuite read(String csv) throws IOException {
    return SuiteCsv.read(
        new ByteArrayInputStream(csv.getBytes(StandardCharsets.UTF_8)), "cases.csv", SUITE);
  }

  private static List<ExpectedValue> expected(String literal) {
    return List.of(new ExpectedValue("", literal));
  }
}
