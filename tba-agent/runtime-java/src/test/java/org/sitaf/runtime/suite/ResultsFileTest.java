package org.sitaf.runtime.suite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Random;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.w3c.dom.Document;

class ResultsFileTest {
  @TempDir Path folder;

  private static TestCase aCase(int no, String value) {
    return new TestCase(no, true, Map.of("Text", value));
  }

  private static CaseResult returning(int no, String value) {
    CaseResult result = new CaseResult(aCase(no, value));
    result.record("return", value);
    result.setTime(1.2345, 0.1, 0);
    return result;
  }

  private static Document parse(String line) throws Exception {
    return DocumentBuilderFactory.newInstance()
        .newDocumentBuilder()
        .parse(new ByteArrayInputStream(line.getBytes(StandardCharsets.UTF_8)));
  }

  @Test
  void writesTheMeasurements() {
    CaseResult result = new CaseResult(aCase(7, "5"));
    result.record("return", 5.0);
    result.record("robot_x", 0.25);
    result.setTime(1.2345, 0.25, 0);
    assertThat(result.line())
        .isEqualTo(
            "<case_record no=\"7\" outcome=\"RETURNED\"><actual name=\"return\">5.0</actual><actual"
                + " name=\"robot_x\">0.25</actual><processing_time unit=\"us\" hardware=\"0.250\""
                + " stub=\"0.000\">1.235</processing_time></case_record>\n");
  }

  @Test
  void recordsTheTypeNameOfAnException() {
    CaseResult result = new CaseResult(aCase(7, "5"));
    result.threw(new IllegalStateException("too fast"), "too fast, really");
    assertThat(result.line())
        .isEqualTo(
            "<case_record no=\"7\" outcome=\"THREW\"><thrown>IllegalStateException</thrown>"
                + "<message>too fast, really</message></case_record>\n");
  }

  @Test
  void writesAnyTextOnOneLineWithoutLoss() throws Exception {
    Random random = new Random(4);
    int[] awkward = {
      '<', '>', '&', '"', '\'', '\n', '\r', '\t', ' ', ']', 0x85, 0x2028, 0x1F916, 0xE9
    };
    for (int i = 0; i < 300; i++) {
      StringBuilder text = new StringBuilder();
      for (int k = random.nextInt(12); k >= 0; k--) {
        text.appendCodePoint(awkward[random.nextInt(awkward.length)]);
      }
      String line = returning(1, text.toString()).line();
      assertThat(line.lines()).hasSize(1);
      assertThat(line).doesNotContain("\u2028", "\u0085");
      Document parsed = parse(line);
      assertThat(parsed.getElementsByTagName("actual").item(0).getTextContent())
          .isEqualTo(text.toString());
    }
  }

  @Test
  void escapesCharactersThatXmlCannotContain() throws Exception {
    String line = returning(1, "a\u0000b\u001b\uD800\uFFFE").line();
    assertThat(parse(line).getElementsByTagName("actual").item(0).getTextContent())
        .isEqualTo("a\\u0000b\\u001B\\uD800\\uFFFE");
  }

  @Test
  void truncatesLongMessagesWithANote() {
    CaseResult result = new CaseResult(aCase(1, ""));
    result.endWith(Outcome.ERROR, "x".repeat(100_000));
    assertThat(result.line()).hasSizeLessThan(9000).contains("... (100000 characters)");
  }

  @Test
  void appendsAfterTerminatingAnIncompleteLine() throws Exception {
    Path file = folder.resolve("results");
    try (ResultsFile results = ResultsFile.create(file)) {
      results.save(returning(1, "x"));
    }
    String first = Files.readString(file);
    Files.writeString(file, first + "<case_record no=\"2\" out");
    try (ResultsFile results = ResultsFile.append(file)) {
      results.save(returning(2, "y"));
    }
    List<String> lines = Files.readAllLines(file);
    assertThat(lines).hasSize(3);
    assertThat(lines.get(0) + "\n").isEqualTo(first);
    assertThat(lines.get(2))
        .startsWith("<case_record no=\"2\" outcome=\"RETURNED\">")
        .endsWith("</case_record>");
  }

  @Test
  void startsEachLineWithNumberAndTokenOnADescriptor() throws Exception {
    Path file = Files.createFile(folder.resolve("channel"));
    try (java.io.RandomAccessFile opened = new java.io.RandomAccessFile(file.toFile(), "rw")) {
      try (ResultsFile results = ResultsFile.open("fd:" + descriptorOf(file), false)) {
        results.authorise(() -> "secret");
        results.ready();
        results.save(returning(7, "x"));
      }
      assertThat(opened.length()).isPositive();
    }
    List<String> lines = Files.readAllLines(file);
    assertThat(lines.get(0)).isEqualTo("1 secret ");
    assertThat(lines.get(1)).startsWith("2 secret <case_record no=\"7\" outcome=\"RETURNED\">");
    assertThat(lines).hasSize(2);
  }

  @Test
  void rejectsADescriptorWithoutAToken() throws Exception {
    Path file = Files.createFile(folder.resolve("channel"));
    try (java.io.RandomAccessFile opened = new java.io.RandomAccessFile(file.toFile(), "rw");
        ResultsFile results = ResultsFile.open("fd:" + descriptorOf(file), false)) {
      assertThat(opened.length()).isZero();
      assertThatThrownBy(() -> results.authorise(() -> null))
          .isInstanceOf(IOException.class)
          .hasMessageContaining("no line with the token");
    }
  }

  @Test
  void needsNoTokenForAFile() throws Exception {
    Path file = folder.resolve("results");
    try (ResultsFile results = ResultsFile.open(file.toString(), false)) {
      results.authorise(
          () -> {
            throw new AssertionError("must not be called");
          });
      results.ready();
    }
    assertThat(Files.readString(file)).isEqualTo("\n");
  }

  /** The number of a file that this process has open. */
  private static String descriptorOf(Path file) throws IOException {
    try (var descriptors = Files.newDirectoryStream(Path.of("/proc/self/fd"))) {
      for (Path descriptor : descriptors) {
        if (Files.isSymbolicLink(descriptor)
            && Files.readSymbolicLink(descriptor).equals(file.toRealPath())) {
          return descriptor.getFileName().toString();
        }
      }
    }
    throw new AssertionError(file + " is not open");
  }
}
