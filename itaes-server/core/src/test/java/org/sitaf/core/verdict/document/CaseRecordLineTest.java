package org.sitaf.core.verdict.document;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import net.jqwik.api.Arbitraries;
import net.jqwik.api.Arbitrary;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.Provide;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.core.timing.Timing;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.PortChanges;
import org.sitaf.core.verdict.StubCalls;

class CaseRecordLineTest {
  private static final String WHOLE =
      "<case_record no=\"7\" outcome=\"RETURNED\">"
          + "<actual name=\"return\">3</actual><actual name=\"pose\">{x: &quot;1&quot;}</actual>"
          + "<call method=\"Finder.Get\"><argument name=\"index\">1</argument></call>"
          + "<call method=\"Finder.Stop\"></call><calls_left_out>12</calls_left_out>"
          + "<processing_time unit=\"us\" hardware=\"12.000\" stub=\"1.250\">87.500"
          + "</processing_time></case_record>";

  @Test
  void readsALineOfARuntime() {
    assertThat(CaseRecordLine.read(WHOLE))
        .isEqualTo(
            new CaseRecord(
                7,
                Outcome.RETURNED,
                "",
                List.of(new NamedValue("return", "3"), new NamedValue("pose", "{x: \"1\"}")),
                new StubCalls(
                    List.of(
                        new StubCalls.Call("Finder.Get", List.of(new NamedValue("index", "1"))),
                        new StubCalls.Call("Finder.Stop", List.of())),
                    12),
                new CaseResult.ProcessingTime(87.5, 12, 1.25),
                ""));
  }

  @Test
  void readsTheValuesOfDataPorts() {
    String ports =
        "<port name=\"state.on\" left_out=\"0\"><at ns=\"-4000000\">false</at><at ns=\"0\">true</at>"
            + "</port><port name=\"speed\" left_out=\"12\"></port>";
    assertThat(CaseRecordLine.read(WHOLE.replace("<processing", ports + "<processing")).ports())
        .containsExactly(
            new PortChanges(
                "state.on",
                List.of(
                    new PortChanges.Change(-4_000_000, "false"), new PortChanges.Change(0, "true")),
                0),
            new PortChanges("speed", List.of(), 12));
    assertThat(CaseRecordLine.read(WHOLE).ports()).isEmpty();
  }

  @Test
  void readsAnExceptionWithTypeAndMessage() {
    CaseRecord record =
        CaseRecordLine.read(
            "<case_record no=\"1\" outcome=\"THREW\"><thrown>NoEcho</thrown>"
                + "<message>robot.NoEcho: a &lt; b&#10;\ud83e\udd16</message></case_record>");

    assertThat(record.thrown()).isEqualTo("NoEcho");
    assertThat(record.message()).isEqualTo("robot.NoEcho: a < b\n\ud83e\udd16");
  }

  private static final String REPEATED =
      "<case_record no=\"1\" outcome=\"RETURNED\"><processing_time unit=\"us\" hardware=\"0.000\""
          + " stub=\"0.000\">370.000</processing_time><repeated_calls>%s</repeated_calls>%s"
          + "</case_record>";

  @Test
  void readsRepeatedCallsThatWereOrdered() {
    String line = REPEATED.formatted("4000 6000", "<differs>call 7: return is 1, not 0</differs>");
    assertThat(CaseRecordLine.read(line, new Timing(3, 2)).repeated())
        .isEqualTo(
            new RepeatedCalls(
                3, 2, 5.0, null, null, List.of(4.0, 6.0), "call 7: return is 1, not 0"));
    assertThat(CaseRecordLine.read(REPEATED.formatted("", ""), new Timing(3, 2)).repeated().calls())
        .isZero();
  }

  @Test
  void rejectsRepeatedCallsThatWereNotOrdered() {
    assertThatThrownBy(() -> CaseRecordLine.read(REPEATED.formatted("4000", "")))
        .hasMessageContaining("expected '</case_record>'");
    for (String nanos : List.of("1 2 3", "-1", "1  2", "1e3", "1 ")) {
      assertThatThrownBy(() -> CaseRecordLine.read(REPEATED.formatted(nanos, ""), new Timing(0, 2)))
          .as(nanos)
          .isInstanceOf(InvalidInputException.class);
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "<test_result no=\"1\" verdict=\"PASS\"></test_result>",
        "<case_record no=\"1\" outcome=\"PASS\"></case_record>",
        "<case_record no=\"1\" outcome=\"THREW\"></case_record>",
        "<case_record no=\"9999999999\" outcome=\"ERROR\"></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><message>&apos;</message></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><message>&#65;</message></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><message>\ud83e</message></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><message>a</message></case_record> ",
        "<case_record no=\"1\" outcome=\"RETURNED\"><actual>3</actual></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><port name=\"a\"></port></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><port name=\"a\" left_out=\"-1\"></port></case_record>",
        "<case_record no=\"1\" outcome=\"ERROR\"><port name=\"a\" left_out=\"0\"><at ns=\"x\">1</at></port></case_record>"
      })
  void rejectsAnyOtherLineWithThePosition(String line) {
    assertThatThrownBy(() -> CaseRecordLine.read(line))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("not a case_record: at character");
  }

  /** Components may write lines, too, and a killed process leaves incomplete ones. */
  @Property(tries = 1000)
  void readsOrRejectsDamagedLines(@ForAll("damage") String damage, @ForAll double where) {
    int at = (int) (Math.abs(where) % 1 * WHOLE.length());
    for (String damaged :
        List.of(WHOLE.substring(0, at) + damage + WHOLE.substring(at), WHOLE.substring(0, at))) {
      try {
        assertThat(CaseRecordLine.read(damaged).outcome()).isNotNull();
      } catch (InvalidInputException e) {
        assertThat(e).hasMessageContaining("not a case_record");
      }
    }
  }

  @Provide
  Arbitrary<String> damage() {
    return Arbitraries.of(
        "<",
        ">",
        "&",
        "\"",
        "\n",
        " ",
        "&#1;",
        "&#xD;",
        "\u0001",
        "\ud800",
        "-",
        "9999999999",
        ".",
        "]]>",
        "<!--x-->",
        "\uffff",
        "\u0085");
  }
}
