package org.sitaf.core.verdict.document;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.sitaf.core.timing.Timing;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepRecord;

/**
 * The records in docs/test-application.md are read: "test-application-2-xml",
 * "test-application-3-xml" and "test-application-4-xml".
 */
class DocumentedRecordsTest {
  private static final Path PAGE = Path.of("../../docs/test-application.md");
  private static final Pattern RECORD =
      Pattern.compile("<(case|step)_record .*?</\\1_record>", Pattern.DOTALL);

  /** The records of the page in their order, each in one line as a runtime writes it. */
  private static List<String> records() throws IOException {
    return RECORD
        .matcher(Files.readString(PAGE))
        .results()
        .map(found -> found.group().replace("\n", ""))
        .toList();
  }

  @Test
  void theRecordOfACaseIsRead() throws IOException {
    CaseRecord returned = CaseRecordLine.read(records().get(0));
    assertThat(returned.outcome()).isEqualTo(Outcome.RETURNED);
    assertThat(returned.actual())
        .containsExactly(new NamedValue("return", "3"), new NamedValue("pose", "{x: 1.0, y: 0.0}"));
    assertThat(returned.calls().leftOut()).isEqualTo(12);
    CaseRecord thrown = CaseRecordLine.read(records().get(1));
    assertThat(thrown.outcome()).isEqualTo(Outcome.THREW);
    assertThat(thrown.message()).startsWith("robot.NoEcho: too far");
  }

  @Test
  void theRecordOfRepeatedCallsIsRead() throws IOException {
    CaseRecord record = CaseRecordLine.read(records().get(2), new Timing(1, 3));
    assertThat(record.repeated().calls()).isEqualTo(3);
    assertThat(record.repeated().differs()).isEqualTo("call 4: return is 2, not 3");
  }

  @Test
  void theRecordOfAStepIsRead() throws IOException {
    StepRecord step = CaseRecordLine.readStep(records().get(3));
    assertThat(step.name()).isEqualTo("Read");
    assertThat(records()).hasSize(4);
  }
}
