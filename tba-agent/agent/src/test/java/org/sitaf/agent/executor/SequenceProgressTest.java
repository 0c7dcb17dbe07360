package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.StepParameters;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.Verdict;

/** The records of steps that a process writes before the record of their case. */
class SequenceProgressTest {
  private final List<CaseRecord> records = new ArrayList<>();
  private final CaseProgress progress =
      new CaseProgress(
          suite(),
          null,
          record -> {
            records.add(record);
            return new CaseResult(
                record.no(), Verdict.PASS, List.of(), List.of(), List.of(), null, "");
          },
          new OutputSink() {
            @Override
            public void output(String text, int caseNo) {}

            @Override
            public void remark(String line) {}
          });

  private static TestSuite suite() {
    TestStep enable = new TestStep("Enable", true, List.of(), List.of());
    TestStep read = new TestStep("Read", true, List.of(), List.of());
    return new TestSuite(
        "s",
        "",
        "m",
        new Generation(new Strength(2), InvalidValues.ISOLATE, 1, "default", "test"),
        List.of(),
        List.of(new StepParameters("Enable", List.of()), new StepParameters("Read", List.of())),
        List.of(
            new TestCase(1, true, List.of(), List.of(), List.of(enable, read)),
            new TestCase(2, true, List.of(), List.of(), List.of(read))));
  }

  private void step(int no, int number, String name) {
    progress.content(
        "<step_record no=\""
            + no
            + "\" step=\""
            + number
            + "\" name=\""
            + name
            + "\" outcome=\"RETURNED\" at_ns=\"0\"></step_record>");
  }

  private void end(int no) {
    progress.content("<case_record no=\"" + no + "\" outcome=\"RETURNED\"></case_record>");
  }

  private static List<String> names(CaseRecord record) {
    return record.steps().stream().map(StepRecord::name).toList();
  }

  @Test
  void a_case_has_the_steps_that_were_recorded_before_it() {
    step(1, 1, "Enable");
    step(1, 2, "Read");
    assertThat(progress.count()).isZero();
    end(1);
    step(2, 1, "Read");
    end(2);
    assertThat(progress.isComplete()).isTrue();
    assertThat(names(records.get(0))).containsExactly("Enable", "Read");
    assertThat(names(records.get(1))).containsExactly("Read");
    assertThat(progress.suspicions()).isEmpty();
  }

  @Test
  void a_process_that_ends_keeps_the_steps_that_ended() {
    step(1, 1, "Enable");
    progress.currentFailed("signal 11");
    assertThat(records.get(0).outcome()).isEqualTo(CaseRecord.Outcome.ERROR);
    List<StepRecord> steps = records.get(0).steps();
    assertThat(names(records.get(0))).containsExactly("Enable", "Read");
    assertThat(steps.get(0).record().outcome()).isEqualTo(CaseRecord.Outcome.RETURNED);
    assertThat(steps.get(1).record().message()).isEqualTo("signal 11");
  }

  @Test
  void a_process_that_never_was_ready_has_no_step_that_failed() {
    progress.beginProcess();
    progress.currentFailed("exit code 3");
    assertThat(records.get(0).steps()).isEmpty();
  }

  @Test
  void a_repeated_case_begins_without_steps() {
    step(1, 1, "Enable");
    progress.beginProcess();
    step(1, 1, "Enable");
    step(1, 2, "Read");
    end(1);
    assertThat(names(records.get(0))).containsExactly("Enable", "Read");
    assertThat(progress.suspicions()).isEmpty();
  }

  @Test
  void steps_of_another_number_name_or_case_are_suspect_and_ignored() {
    step(1, 2, "Read");
    step(1, 1, "Read");
    step(2, 1, "Read");
    step(1, 1, "Enable");
    step(1, 1, "Enable");
    step(1, 2, "Read");
    step(1, 3, "Read");
    end(1);
    assertThat(names(records.get(0))).containsExactly("Enable", "Read");
    assertThat(progress.suspicions())
        .containsExactly("a result of a step that is not the next one of the case (5 times)");
  }

  @Test
  void a_step_whose_record_is_too_long_is_an_error_and_the_case_goes_on() {
    progress.tooLong();
    step(1, 2, "Read");
    end(1);
    assertThat(records.get(0).steps().get(0).record().outcome())
        .isEqualTo(CaseRecord.Outcome.ERROR);
    assertThat(names(records.get(0))).containsExactly("Enable", "Read");
  }
}
