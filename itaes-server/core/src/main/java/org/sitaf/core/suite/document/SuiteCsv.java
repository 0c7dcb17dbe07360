package org.sitaf.core.suite.document;

import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Reader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.sitaf.core.diagnostic.Diagnostics;
import org.sitaf.core.document.CsvCells;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.ExpectedValue;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * Reads and writes the cases of a suite as comma-separated values: a header {@code
 * no,class,PARAMETER...,expected OUTPUT...} and one line per case; sequences have one line per step
 * and are only written. See {@link CsvCells}.
 */
public final class SuiteCsv {
  private static final String EXPECTED = "expected";

  private SuiteCsv() {}

  /** Writes all cases. The same suite gives the same bytes. */
  public static void write(TestSuite suite, OutputStream out) throws IOException {
    Writer writer = new OutputStreamWriter(out, StandardCharsets.UTF_8);
    if (suite.isOfSequences()) {
      SequenceCsv.write(suite, writer);
      writer.flush();
      return;
    }
    List<String> outputs =
        suite.cases().stream()
            .flatMap(c -> c.expected().stream().map(ExpectedValue::output))
            .distinct()
            .toList();
    List<String> header = new ArrayList<>(List.of("no", "class"));
    suite.parameters().stream().map(CaseParameter::name).forEach(header::add);
    outputs.forEach(o -> header.add(o.isEmpty() ? EXPECTED : EXPECTED + " " + o));
    writer.write(CsvCells.line(header));
    for (TestCase testCase : suite.cases()) {
      List<String> line = new ArrayList<>();
      line.add(Integer.toString(testCase.no()));
      line.add(testCase.valid() ? "valid" : "invalid");
      line.addAll(testCase.values());
      outputs.forEach(o -> line.add(expected(testCase, o)));
      writer.write(CsvCells.line(line));
    }
    writer.flush();
  }

  /**
   * Replaces the cases of a suite by those of a document. If the field of an expected value is
   * empty, nothing is expected.
   *
   * @param file name of the document, for diagnostics
   * @throws org.sitaf.core.diagnostic.InvalidInputException with all invalid lines
   */
  public static TestSuite read(InputStream csv, String file, TestSuite suite) throws IOException {
    Diagnostics diagnostics = new Diagnostics();
    if (suite.isOfSequences()) {
      diagnostics.error(
          file, 0, "", "sequences cannot be read from CSV; use the XML document of the suite");
      diagnostics.throwIfErrors();
    }
    List<Line> lines = lines(new InputStreamReader(csv, StandardCharsets.UTF_8));
    List<String> start = new ArrayList<>(List.of("no", "class"));
    suite.parameters().stream().map(CaseParameter::name).forEach(start::add);
    List<String> header = lines.isEmpty() ? List.of() : lines.get(0).fields();
    int known = start.size();
    if (header.size() < known
        || !header.subList(0, known).equals(start)
        || !header.subList(known, header.size()).stream().allMatch(h -> h.startsWith(EXPECTED))) {
      diagnostics.error(
          file, 1, "header", "must be " + String.join(",", start) + ", then expected columns");
      diagnostics.throwIfErrors();
    }
    List<String> outputs =
        header.subList(known, header.size()).stream()
            .map(h -> h.substring(EXPECTED.length()).strip())
            .toList();
    List<TestCase> cases = new ArrayList<>();
    for (Line line : lines.subList(1, lines.size())) {
      try {
        cases.add(read(line.fields(), header, outputs, known));
      } catch (IllegalArgumentException e) {
        diagnostics.error(file, line.number(), "", String.valueOf(e.getMessage()));
      }
    }
    diagnostics.throwIfErrors();
    try {
      return suite.withCases(cases);
    } catch (IllegalArgumentException e) {
      diagnostics.error(file, 0, "", String.valueOf(e.getMessage()));
      diagnostics.throwIfErrors();
      throw e;
    }
  }

  private static TestCase read(
      List<String> fields, List<String> header, List<String> outputs, int known) {
    if (fields.size() != header.size()) {
      throw new IllegalArgumentException(
          "has " + fields.size() + " fields, the header has " + header.size());
    }
    String kind = fields.get(1);
    if (!kind.equals("valid") && !kind.equals("invalid")) {
      throw new IllegalArgumentException("class must be valid or invalid, not '" + kind + "'");
    }
    List<ExpectedValue> expected = new ArrayList<>();
    for (int i = 0; i < outputs.size(); i++) {
      String literal = fields.get(known + i);
      if (!literal.isEmpty()) {
        expected.add(new ExpectedValue(outputs.get(i), literal));
      }
    }
    return new TestCase(
        number(fields.get(0)), kind.equals("valid"), fields.subList(2, known), expected);
  }

  private static int number(String field) {
    try {
      return Integer.parseInt(field);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("no must be a whole number, not '" + field + "'", e);
    }
  }

  /** The fields of a record, and the number of its first line. */
  private record Line(int number, List<String> fields) {}

  private static List<Line> lines(Reader reader) throws IOException {
    List<Line> lines = new ArrayList<>();
    List<String> fields = new ArrayList<>();
    StringBuilder field = new StringBuilder();
    boolean quoted = false;
    boolean closed = false;
    int number = 1;
    int begun = 1;
    for (int c = reader.read(); c >= 0; c = reader.read()) {
      if (c == '\n') {
        number++;
      }
      if (quoted) {
        if (c != '"') {
          field.append((char) c);
          continue;
        }
        quoted = false;
        closed = true;
        continue;
      }
      if (c == '"') {
        // Two quotes within a quoted field are one literal quote.
        if (closed) {
          field.append('"');
        }
        quoted = true;
      } else if (c == ',' || c == '\n') {
        fields.add(CsvCells.read(field.toString()));
        field.setLength(0);
        if (c == '\n') {
          addLine(lines, begun, fields);
          begun = number;
          fields = new ArrayList<>();
        }
      } else if (c != '\r' && c != '\ufeff') {
        field.append((char) c);
      }
      closed = false;
    }
    if (field.length() > 0 || !fields.isEmpty()) {
      fields.add(CsvCells.read(field.toString()));
      addLine(lines, begun, fields);
    }
    return lines;
  }

  private static void addLine(List<Line> lines, int number, List<String> fields) {
    if (fields.size() > 1 || !fields.get(0).isEmpty()) {
      lines.add(new Line(number, fields));
    }
  }

  private static String expected(TestCase testCase, String output) {
    return testCase.expected().stream()
        .filter(e -> e.output().equals(output))
        .map(ExpectedValue::literal)
        .findFirst()
        .orElse("");
  }
}
