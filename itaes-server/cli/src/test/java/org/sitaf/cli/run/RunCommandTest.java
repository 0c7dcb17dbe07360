package org.sitaf.cli.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sitaf.cli.Sitaf;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.Summary;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

class RunCommandTest {
  private static final Provenance PROVENANCE = new Provenance("", 1, "", "", "", "", "", "");

  @TempDir private Path directory;

  private String errorsOf(int exitCode, String... arguments) {
    StringWriter err = new StringWriter();
    List<String> all = new ArrayList<>(List.of("run"));
    all.addAll(List.of(arguments));
    int ended =
        Sitaf.commandLine().setErr(new PrintWriter(err, true)).execute(all.toArray(String[]::new));
    assertThat(ended).isEqualTo(exitCode);
    return err.toString();
  }

  private static TestResult result(int pass, int fail, int error, int dont) {
    List<CaseResult> cases = new ArrayList<>();
    int total = pass + fail + error + dont;
    for (int no = 1; no <= total; no++) {
      Verdict verdict =
          no <= pass
              ? Verdict.PASS
              : no <= pass + fail
                  ? Verdict.FAIL
                  : no <= pass + fail + error ? Verdict.ERROR : Verdict.DONT;
      cases.add(
          new CaseResult(
              no, verdict, List.of(), List.of(), List.of(), null, "first line\nsecond line"));
    }
    Summary summary = new Summary(total, pass, fail, error, dont, 0, 0, null);
    return new TestResult("Model", PROVENANCE, summary, List.of(), cases, null);
  }

  @ParameterizedTest
  @CsvSource({
    "3, 0, 0, 0, 0",
    "2, 1, 0, 0, 1",
    "2, 0, 1, 0, 1",
    "0, 0, 20, 35, 1",
    "2, 0, 0, 1, 2",
    "0, 0, 0, 0, 2"
  })
  void exitsWith1IfAnyCaseFailed(int pass, int fail, int error, int dont, int exitCode) {
    assertThat(RunCommand.exitCode(result(pass, fail, error, dont))).isEqualTo(exitCode);
  }

  @Test
  void aFailedModelDeterminesTheExitCode() {
    assertThat(RunCommand.worse(2, 1)).isEqualTo(1);
    assertThat(RunCommand.worse(1, 2)).isEqualTo(1);
    assertThat(RunCommand.worse(0, 2)).isEqualTo(2);
    assertThat(RunCommand.worse(0, 0)).isZero();
  }

  @Test
  void theSummaryCountsCasesThatWereNotExecuted() {
    StringWriter out = new StringWriter();
    ResultTable.printSummary(result(0, 0, 20, 35), new PrintWriter(out));

    assertThat(out.toString())
        .startsWith("Model: 55 cases, 0 PASS, 0 FAIL, 20 ERROR, 35 DONT (not executed)");
  }

  @Test
  void printsTheLinesOfAMessage() {
    StringWriter out = new StringWriter();
    TestResult result = result(0, 0, 1, 0);
    ResultTable.printCases(result, result.cases(), new PrintWriter(out, true));

    assertThat(out.toString())
        .contains("first line" + System.lineSeparator() + "    second line")
        .doesNotContain("u000a");
  }

  @Test
  void reportsAnInvalidResultFileBeforeTheRun() {
    assertThat(errorsOf(2, "nowhere", "--model", "X", "--result", directory.toString()))
        .contains("--result " + directory + ": error: is a folder; name a file")
        .doesNotContain("nowhere");
    assertThat(errorsOf(2, "nowhere", "--junit", directory.resolve("no/such.xml").toString()))
        .contains("the folder " + directory.resolve("no") + " does not exist; create it");
  }

  @Test
  void requiresAFolderForResultsOfAllModels() throws Exception {
    Path file = Files.createFile(directory.resolve("result.xml"));
    assertThat(errorsOf(2, "nowhere", "--result", file.toString()))
        .contains("--result " + file + ": error: is a file; name a folder");
  }

  @Test
  void refusesOptionsThatDoNotFitTheDebugger() {
    assertThat(errorsOf(2, "folder", "--print-command")).contains("--print-command needs --debug");
    assertThat(errorsOf(2, "folder", "--debug", "--server", "https://example.org"))
        .contains("--debug is not available with --server");
    assertThat(errorsOf(2, "folder", "--debug", "--repeat", "2"))
        .contains("--debug runs a case once; leave out --repeat and --until-failure");
    assertThat(errorsOf(2, "folder", "--debug", "--sandbox", "required"))
        .contains("--debug is not available with --sandbox=required: a debugger cannot reach");
  }

  /** Names of outputs and notes come from the component. */
  @Test
  void printsNoEscapeSequencesOfAComponent() {
    String escape = "\u001b]0;x\u0007\u202e";
    NamedValue value = new NamedValue(escape, escape);
    CaseResult hostile =
        new CaseResult(1, Verdict.PASS, List.of(), List.of(value), List.of(value, value), null, "")
            .withNotes(List.of("nothing observes the topic " + escape));
    TestResult result =
        new TestResult(
            "Model",
            PROVENANCE,
            new Summary(1, 1, 0, 0, 0, 0, 0, null),
            List.of(),
            List.of(hostile),
            null);
    StringWriter out = new StringWriter();
    ResultTable.printAll(result, new PrintWriter(out));
    ResultTable.printSummary(result, new PrintWriter(out));
    assertThat(out.toString())
        .contains("nothing observes the topic \\u001b")
        .doesNotContain("\u001b", "\u0007", "\u202e");
  }
}
