package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.as;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.STRING;

import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.timing.Timing;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.Verdict;

/** Lines in the results channel and how they are handled. */
@Tag("slow")
@Timeout(300)
class ResultsChannelTest {
  @TempDir private Path folder;
  private final List<String> remarks = new ArrayList<>();
  private final TestApplication application = EchoActivity.withBody("").application();
  private CaseProgress progress = progress(null);
  private ResultsChannel channel;
  private OutputStream driver;

  @BeforeEach
  void open() throws Exception {
    channel = ResultsChannel.open(folder);
    driver = new FileOutputStream(channel.pipe().toFile());
    progress.processHasRun(1e6);
  }

  @AfterEach
  void close() throws IOException {
    driver.close();
    channel.close();
    assertThat(folder).isEmptyDirectory();
  }

  private CaseProgress progress(@Nullable Timing timing) {
    return new CaseProgress(
        application.suite(),
        timing,
        new ResultAssembler(application.model(), application.suite())::judge,
        new OutputSink() {
          @Override
          public void output(String text, int caseNo) {}

          @Override
          public void remark(String line) {
            remarks.add(line);
          }
        });
  }

  private boolean write(String text) throws IOException {
    driver.write(text.getBytes(StandardCharsets.UTF_8));
    return channel.read(progress);
  }

  private boolean line(int number, String content) throws IOException {
    return write(number + " " + channel.token() + " " + content + "\n");
  }

  private static String passed(int no) {
    return passed(no, "" + no, "1.5");
  }

  private static String passed(int no, String value, String time) {
    return "<case_record no=\"%d\" outcome=\"RETURNED\"><actual name=\"return\">%s</actual>"
            .formatted(no, value)
        + "<processing_time unit=\"us\" hardware=\"0.000\" stub=\"0.000\">%s".formatted(time)
        + "</processing_time></case_record>";
  }

  @Test
  void acceptsNumberedLinesWithTheToken() throws Exception {
    assertThat(line(1, "")).isTrue();
    assertThat(progress.isReady()).isTrue();
    assertThat(channel.pipe()).doesNotExist();
    for (int no = 1; no <= 5; no++) {
      assertThat(line(no + 1, passed(no))).isTrue();
    }
    assertThat(progress.isComplete()).isTrue();
    assertThat(progress.results()).extracting(CaseResult::verdict).containsOnly(Verdict.PASS);
    assertThat(progress.suspicions()).isEmpty();
    assertThat(remarks).isEmpty();
  }

  private static String repeated(int no, String nanos) {
    return passed(no)
        .replace("</case_record>", "<repeated_calls>" + nanos + "</repeated_calls></case_record>");
  }

  @Test
  void onlyTheFirstCallOfAProcessIsCold() throws Exception {
    line(1, "");
    line(2, "<case_record no=\"1\" outcome=\"NOT_CALLED\"></case_record>");
    line(3, passed(2));
    line(4, passed(3));
    progress.beginProcess();
    line(5, passed(4));
    line(6, passed(5));
    assertThat(progress.results().stream().filter(r -> r.time() != null && r.time().cold()))
        .extracting(CaseResult::no)
        .containsExactly(2, 4);
  }

  @Test
  void impossibleRepeatedCallsAreSuspect() throws Exception {
    line(1, "");
    line(2, repeated(1, "4000 5000"));
    assertThat(progress.suspicions())
        .singleElement(as(STRING))
        .startsWith("a numbered line is not a case_record");

    progress = progress(new Timing(0, 2));
    progress.processHasRun(1e6);
    line(3, "");
    line(4, repeated(1, "4000 5000"));
    assertThat(progress.suspicions()).isEmpty();
    // 0.6 s each in a process that ran for one second.
    line(5, repeated(2, "600000000 600000000"));
    line(6, repeated(3, "1 2 3"));
    assertThat(progress.results())
        .extracting(r -> r.repeated() != null)
        .containsExactly(true, false);
    assertThat(progress.suspicions()).hasSize(2);
  }

  @Test
  void aForgedLineIsNeitherAResultNorProgress() throws Exception {
    line(1, "");
    String guessed = "0".repeat(channel.token().length());

    assertThat(write("\n")).isFalse();
    assertThat(write(passed(1) + "\n")).isFalse();
    assertThat(write("2 " + guessed + " " + passed(1) + "\n")).isFalse();
    assertThat(write(channel.token() + " " + passed(1) + "\n")).isFalse();
    assertThat(write("two " + channel.token() + " " + passed(1) + "\n")).isFalse();
    assertThat(write("2 " + channel.token() + passed(1) + "\n")).isFalse();
    assertThat(progress.count()).isZero();
    assertThat(progress.suspicions())
        .containsExactly(
            "a line without number and token (5 times)", "got line -1, expected line 2");
    assertThat(line(2, passed(1))).isTrue();
    assertThat(progress.count()).isEqualTo(1);
  }

  @Test
  void rejectsARepeatedLine() throws Exception {
    line(1, "");
    line(2, passed(1));
    assertThat(line(2, passed(2))).isFalse();

    assertThat(progress.count()).isEqualTo(1);
    assertThat(progress.suspicions()).containsExactly("got line 2, expected line 3");
  }

  @Test
  void aMissingLineIsSuspectAndLaterResultsCount() throws Exception {
    line(1, "");
    line(3, passed(1));

    assertThat(progress.count()).isEqualTo(1);
    assertThat(progress.suspicions()).containsExactly("got line 3, expected line 2");
  }

  @Test
  void resultsOfOtherCasesAreSuspect() throws Exception {
    line(1, "");
    line(2, passed(2));
    line(3, passed(2));
    line(4, passed(9));

    assertThat(progress.results()).extracting(CaseResult::no).containsExactly(2);
    assertThat(progress.suspicions())
        .containsExactly(
            "results arrived in another order than the cases of the suite",
            "a second result of a case",
            "a result of a case that is not in the suite");
  }

  @Test
  void judgesTheRecordedValues() throws Exception {
    line(1, "");
    line(2, passed(1, "7", "1.5"));

    CaseResult result = progress.results().get(0);
    assertThat(result.values()).containsExactly("1");
    assertThat(result.expected().get(0).literal()).isEqualTo("1");
    assertThat(result.verdict()).isEqualTo(Verdict.FAIL);
    assertThat(result.message()).isEqualTo("expected 1, but was 7");
  }

  @Test
  void ignoresAnImpossibleProcessingTime() throws Exception {
    line(1, "");
    line(2, passed(1, "1", "1000000"));
    line(3, passed(2, "2", "9000000"));
    line(4, passed(3, "3", "-1"));

    assertThat(progress.results().get(0).time()).isNotNull();
    assertThat(progress.results().subList(1, 3)).extracting(CaseResult::time).containsOnlyNulls();
    assertThat(progress.suspicions())
        .singleElement()
        .asString()
        .contains("processing time", "(2 times)");
  }

  @Test
  void anIncompleteLineIsNotAResult() throws Exception {
    line(1, "");
    write("2 " + channel.token() + " " + passed(1));

    assertThat(progress.count()).isZero();
    assertThat(channel.torn()).isPositive();
    assertThat(progress.suspicions()).isEmpty();
  }

  @Test
  void aTooLongResultIsAnErrorOfItsCase() throws Exception {
    line(1, "");
    Thread writer =
        new Thread(
            () -> {
              try {
                driver.write(("2 " + channel.token() + " ").getBytes(StandardCharsets.UTF_8));
                driver.write(new byte[ResultsChannel.MAX_LINE]);
                driver.write('\n');
              } catch (IOException e) {
                throw new java.io.UncheckedIOException(e);
              }
            });
    writer.start();
    while (progress.count() == 0) {
      channel.read(progress);
    }
    writer.join();

    assertThat(progress.results().get(0).verdict()).isEqualTo(Verdict.ERROR);
    assertThat(progress.results().get(0).message()).contains("longer than 1 MiB");
    assertThat(progress.suspicions()).isEmpty();
  }

  @Test
  void limitsTheNumberOfSuspicions() throws Exception {
    line(1, "");
    for (int i = 0; i < 100_000; i++) {
      line(1 + i % 1000 - 500, "");
    }

    assertThat(remarks).hasSizeLessThan(25);
    assertThat(progress.suspicions()).hasSizeLessThan(25);
    assertThat(progress.suspicions().get(20)).matches("and \\d+ further reasons");
  }
}
