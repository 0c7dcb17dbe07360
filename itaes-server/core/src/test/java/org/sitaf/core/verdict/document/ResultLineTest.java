package org.sitaf.core.verdict.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.Combinators;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Verdict;

/** What is read fast is what is read at leisure, or it is not read fast. */
class ResultLineTest {
  private static final String WHOLE =
      "<test_result no=\"7\" verdict=\"FAIL\"><value>1.5</value><value>a&lt;b&#10;</value>"
          + "<expected name=\"return\">4</expected><expected>5</expected>"
          + "<actual name=\"return\">3</actual><actual name=\"pose\">{x: &quot;1&quot;}</actual>"
          + "<call method=\"Finder.Get\"><argument name=\"index\">1</argument></call>"
          + "<call method=\"Finder.Stop\"></call><calls_left_out>12</calls_left_out>"
          + "<processing_time unit=\"us\" hardware=\"12.000\" stub=\"1.250\">87.500"
          + "</processing_time><message>expected 4, but was 3</message></test_result>";

  @Test
  void aLineAsTheRuntimesWriteItIsReadFast() {
    assertThat(ResultLine.read(WHOLE)).contains(TestResultXml.readAnyCase(WHOLE));
    assertThat(ResultLine.read(WHOLE).orElseThrow().actual())
        .containsExactly(new NamedValue("return", "3"), new NamedValue("pose", "{x: \"1\"}"));
  }

  @Test
  void anotherSpellingIsLeftToTheReaderOfAnyXml() {
    String spaced = WHOLE.replace("</value><", "</value>\n <").replace("no=", " no=");

    assertThat(ResultLine.read(spaced)).isEmpty();
    assertThat(TestResultXml.readCase(spaced)).isEqualTo(TestResultXml.readCase(WHOLE));
  }

  @Property(tries = 500)
  void whateverTextsHoldIsReadAlike(@ForAll("lines") String line) {
    ResultLine.read(line)
        .ifPresent(result -> assertThat(result).isEqualTo(TestResultXml.readAnyCase(line)));
  }

  /** A component may write lines of its own, and a torn or damaged one is nothing to trust. */
  @Property(tries = 1000)
  void aDamagedLineIsReadAlikeOrNotFast(
      @ForAll("lines") String line, @ForAll("damage") String damage, @ForAll double where) {
    int at = (int) (Math.abs(where) % 1 * line.length());
    for (String damaged :
        List.of(
            line.substring(0, at) + damage + line.substring(at),
            line.substring(0, at) + damage + line.substring(Math.min(line.length(), at + 1)),
            line.substring(0, at))) {
      Optional<CaseResult> fast = ResultLine.read(damaged);
      fast.ifPresent(result -> assertThat(result).isEqualTo(atLeisure(damaged)));
    }
  }

  private static Object atLeisure(String line) {
    try {
      return TestResultXml.readAnyCase(line);
    } catch (InvalidInputException e) {
      return e;
    }
  }

  @Provide
  Arbitrary<String> damage() {
    return Arbitraries.of(
        "<",
        ">",
        "&",
        "\"",
        "'",
        "\n",
        " ",
        "&#1;",
        "&#xD;",
        "&apos;",
        "\u0001",
        "\ud800",
        "-",
        "0",
        "9999999999",
        ".",
        "e",
        "]]>",
        "<!--x-->",
        "<value/>",
        "name=\"\"",
        "\uffff",
        "\u0085");
  }

  @Provide
  Arbitrary<String> lines() {
    Arbitrary<String> texts =
        Arbitraries.strings()
            .withChars("ab <>&\"'\n\r\t\u0085\u2028{}[]:;,.#-0\u00e9\u4e2d]]>")
            .ofMaxLength(8)
            .map(ResultLineTest::escaped);
    Arbitrary<String> values = elements("value", texts, texts, false);
    Arbitrary<String> outputs =
        Combinators.combine(
                elements("expected", texts, texts, true), elements("actual", texts, texts, true))
            .as((expected, actual) -> expected + actual);
    Arbitrary<String> calls =
        Combinators.combine(texts, elements("argument", texts, texts, true))
            .as((method, arguments) -> "<call method=\"" + method + "\">" + arguments + "</call>")
            .list()
            .ofMaxSize(2)
            .map(list -> String.join("", list));
    Arbitrary<String> leftOut =
        Arbitraries.longs()
            .between(1, 10_000)
            .map(n -> "<calls_left_out>" + n + "</calls_left_out>")
            .optional()
            .map(o -> o.orElse(""));
    Arbitrary<String> time =
        Arbitraries.doubles()
            .between(0, 1e9)
            .map(
                t ->
                    String.format(
                        Locale.ROOT,
                        "<processing_time unit=\"us\" hardware=\"%.3f\" stub=\"0.000\">%.3f"
                            + "</processing_time>",
                        t / 3,
                        t))
            .optional()
            .map(o -> o.orElse(""));
    Arbitrary<String> message =
        texts.map(t -> "<message>" + t + "</message>").optional().map(o -> o.orElse(""));
    Arbitrary<String> head =
        Combinators.combine(
                Arbitraries.integers().between(1, 999_999_999), Arbitraries.of(Verdict.values()))
            .as((no, verdict) -> "<test_result no=\"" + no + "\" verdict=\"" + verdict + "\">");
    return Combinators.combine(head, values, outputs, calls, leftOut, time, message)
        .as((h, v, o, c, l, t, m) -> h + v + o + c + l + t + m + "</test_result>");
  }

  private static Arbitrary<String> elements(
      String element, Arbitrary<String> names, Arbitrary<String> texts, boolean named) {
    return Combinators.combine(names, texts)
        .as(
            (name, text) ->
                "<"
                    + element
                    + (named && !name.isEmpty() ? " name=\"" + name + "\"" : "")
                    + ">"
                    + text
                    + "</"
                    + element
                    + ">")
        .list()
        .ofMaxSize(3)
        .map(list -> list.stream().collect(Collectors.joining()));
  }

  private static String escaped(String text) {
    StringBuilder escaped = new StringBuilder();
    for (char c : text.toCharArray()) {
      switch (c) {
        case '&' -> escaped.append("&amp;");
        case '<' -> escaped.append("&lt;");
        case '>' -> escaped.append("&gt;");
        case '"' -> escaped.append("&quot;");
        case '\n', '\r', '\t', '\u0085', '\u2028' ->
            escaped.append("&#").append((int) c).append(';');
        default -> escaped.append(c);
      }
    }
    return escaped.toString();
  }
}
