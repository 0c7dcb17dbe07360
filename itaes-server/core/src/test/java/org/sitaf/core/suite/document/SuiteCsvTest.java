package org.sitaf.core.suite.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.Chars;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.document.CsvCells;
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
  void readsWrittenCasesUnchanged() throws IOException {
    ByteArrayOutputStream csv = new ByteArrayOutputStream();
    SuiteCsv.write(SUITE, csv);
    TestSuite read =
        SuiteCsv.read(
            new ByteArrayInputStream(csv.toByteArray()), "cases.csv", SUITE.withCases(List.of()));
    assertThat(read).isEqualTo(SUITE);
  }

  @Test
  void escapesFormulasAndKeepsNumbers() throws IOException {
    for (String formula :
        List.of(
            "=1+1",
            "+1+cmd|' /C calc'!A0",
            "-1-2",
            "@SUM(1)",
            "\t=1",
            "\r=1",
            "-",
            "+",
            "'=1",
            "''@a")) {
      TestSuite suite =
          SUITE.withCases(
              List.of(new TestCase(1, true, List.of(formula, "-1.5e-3"), expected(formula))));
      ByteArrayOutputStream csv = new ByteArrayOutputStream();
      SuiteCsv.write(suite, csv);
      assertThat(csv.toString(StandardCharsets.UTF_8))
          .containsPattern("valid,\"?'")
          .contains(",-1.5e-3,");
      assertThat(read(csv.toString(StandardCharsets.UTF_8))).isEqualTo(suite);
    }
    for (String number : List.of("-1.5", "+2", "-.5", "-Infinity", "1e9", "it's", "'", "'a")) {
      assertThat(CsvCells.line(List.of(number))).isEqualTo(number + "\r\n");
      assertThat(CsvCells.read(number)).isEqualTo(number);
    }
  }

  @Property
  void readsEveryWrittenTextUnchanged(
      @ForAll @Chars({'\'', '=', '+', '-', '1', 'a', ',', '"', '\n', '\t'}) String text)
      throws IOException {
    TestSuite suite =
        SUITE.withCases(List.of(new TestCase(1, true, List.of(text, "1.0"), List.of())));
    ByteArrayOutputStream csv = new ByteArrayOutputStream();
    SuiteCsv.write(suite, csv);
    assertThat(read(csv.toString(StandardCharsets.UTF_8))).isEqualTo(suite);
  }

  @Test
  void reportsInvalidLinesWithTheirNumbers() {
    String csv =
        "no,class,Name,Distance,expected\r\n"
            + "1,valid,a,1.5,2.0\r\n"
            + "x,valid,a,1.5,\r\n"
            + "3,perhaps,a,1.5,\r\n"
            + "4,valid,a\r\n";
    assertThatThrownBy(() -> read(csv))
        .isInstanceOfSatisfying(
            InvalidInputException.class,
            e -> assertThat(e.diagnostics()).extracting(d -> d.line()).containsExactly(3, 4, 5));
  }

  @Test
  void rejectsCasesOfOtherParameters() {
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
