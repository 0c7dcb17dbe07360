package org.sitaf.runtime;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.IntStream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.runtime.suite.CaseResult;
import org.sitaf.runtime.suite.TestCase;

class TestRunTest {
  @TempDir Path folder;
  private Path suite;
  private Path results;

  /** Divides, and counts its instances. */
  public static class Divider implements AutoCloseable {
    static final List<String> LIFE = new ArrayList<>();

    public Divider() {
      LIFE.add("made");
    }

    /** 100 / divisor. */
    public int divide(int divisor) {
      if (divisor == 13) {
        Runtime.getRuntime().halt(42);
      }
      if (divisor == 99) {
        Thread.currentThread().interrupt();
        throw new StackOverflowError();
      }
      if (divisor == 98) {
        Thread.currentThread().interrupt();
      }
      if (divisor == 50 && LIFE.size() > 8) {
        return 0;
      }
      if (divisor == 51 && LIFE.size() > 8) {
        throw new IllegalStateException("the fifth time");
      }
      return 100 / divisor;
    }

    @Override
    public void close() {
      LIFE.add("closed");
    }
  }

  /** A driver like the generated ones. */
  static class DividerDriver extends SuiteDriver<Divider> {
    DividerDriver(TestRun run, LifeCycle lifeCycle) {
      super(run, lifeCycle);
    }

    @Override
    protected Divider createComponent() throws Exception {
      return ComponentUnderTest.create(Divider.class);
    }

    @Override
    protected void runCase(TestCase testCase, CaseResult result) throws Exception {
      int divisor = testCase.intValue("Divisor");
      Divider component = component();
      stopwatch().start();
      int returned = component.divide(divisor);
      stopwatch().stop();
      result.record("return", returned);
      save(result);
    }

    public static void main(String[] arguments) {
      TestRun.start(arguments, run -> new DividerDriver(run, LifeCycle.CASE));
    }
  }

  @BeforeEach
  void paths() {
    suite = folder.resolve("suite.xml");
    results = folder.resolve("results");
    Divider.LIFE.clear();
  }

  /** Cases numbered from 1. */
  private void suiteOf(String... divisors) throws IOException {
    StringBuilder document =
        new StringBuilder(
            "<test_suite_data><name>s</name><case_param_info><param name='Divisor' type='TDI'"
                + " real_type='int'/></case_param_info><case_list>");
    IntStream.range(0, divisors.length)
        .forEach(
            i ->
                document.append(
                    "<case no='%d'><value>%s</value></case>".formatted(i + 1, divisors[i])));
    Files.writeString(suite, document + "</case_list></test_suite_data>");
  }

  private int run(LifeCycle lifeCycle, String... more) {
    List<String> arguments =
        new ArrayList<>(List.of("--suite", suite.toString(), "--results", results.toString()));
    arguments.addAll(List.of(more));
    return TestRun.execute(
        arguments.toArray(String[]::new), run -> new DividerDriver(run, lifeCycle));
  }

  private List<String> lines() throws IOException {
    return Files.readAllLines(results).stream().filter(line -> !line.isEmpty()).toList();
  }

  private static String errorsOf(Runnable action) {
    PrintStream before = System.err;
    ByteArrayOutputStream captured = new ByteArrayOutputStream();
    System.setErr(new PrintStream(captured, true, StandardCharsets.UTF_8));
    try {
      action.run();
    } finally {
      System.setErr(before);
    }
    return captured.toString(StandardCharsets.UTF_8);
  }

  @Test
  void savesAResultForEveryCaseEvenWhenTheComponentFails() throws IOException {
    suiteOf("5", "4", "0", "99", "5");
    assertThat(run(LifeCycle.CASE)).isZero();
    assertThat(lines()).hasSize(5);
    assertThat(lines().get(0))
        .contains("no=\"1\" outcome=\"RETURNED\"")
        .contains("<processing_time");
    assertThat(lines().get(1))
        .contains("no=\"2\" outcome=\"RETURNED\"")
        .contains("<actual name=\"return\">25</actual>");
    assertThat(lines().get(2))
        .contains("no=\"3\" outcome=\"THREW\"><thrown>ArithmeticException</thrown>");
    assertThat(lines().get(3))
        .contains("no=\"4\" outcome=\"THREW\"")
        .contains("StackOverflowError");
    assertThat(lines().get(4)).contains("no=\"5\" outcome=\"RETURNED\"");
    assertThat(Thread.interrupted()).isFalse();
  }

  @Test
  void writesAnEmptyLineBeforeTheFirstCase() throws IOException {
    suiteOf("5");
    run(LifeCycle.CASE);
    assertThat(Files.readString(results)).startsWith("\n<case_record no=\"1\"");
  }

  @Test
  void doesNotExecuteACaseWithInvalidData() throws IOException {
    suiteOf("five", "5");
    assertThat(run(LifeCycle.CASE)).isZero();
    assertThat(lines().get(0))
        .contains("outcome=\"NOT_CALLED\"")
        .contains("Divisor: 'five' is not a number");
    assertThat(lines().get(1)).contains("outcome=\"RETURNED\"");
    assertThat(Divider.LIFE).containsExactly("made", "closed");
  }

  @Test
  void createsComponentsAccordingToTheLifeCycle() throws IOException {
    suiteOf("5", "5");
    run(LifeCycle.CASE);
    assertThat(Divider.LIFE).containsExactly("made", "closed", "made", "closed");
    Divider.LIFE.clear();
    run(LifeCycle.SUITE);
    assertThat(Divider.LIFE).containsExactly("made", "closed");
  }

  @Test
  void continuesARunFromACase() throws IOException {
    suiteOf("5", "4", "5");
    run(LifeCycle.CASE);
    assertThat(run(LifeCycle.CASE, "--from", "2")).isZero();
    assertThat(lines()).hasSize(5);
    assertThat(lines().get(3)).contains("no=\"2\"");
    assertThat(run(LifeCycle.CASE, "--from", "9")).isEqualTo(3);
  }

  @Test
  void reportsInvalidArgumentsInOneLine() throws IOException {
    suiteOf("5");
    String[][] wrong = {
      {"--bridge", "127.0.0.1:1"},
      {"--colour", "red"},
      {"--seed", "minus"},
      {"--warm-up", "3"},
      {"--repeat", "-1"},
      {"--repeat", "3", "--repeat-within", "0"},
      {"--bridge", "127.0.0.1:1", "--world", folder.resolve("missing.world.yaml").toString()}
    };
    for (String[] more : wrong) {
      String errors = errorsOf(() -> assertThat(run(LifeCycle.CASE, more)).isEqualTo(3));
      assertThat(errors).startsWith("sitaf: ").hasLineCount(1);
    }
    Files.delete(suite);
    assertThat(errorsOf(() -> assertThat(run(LifeCycle.CASE)).isEqualTo(3)))
        .startsWith("sitaf: NoSuchFileException");
  }

  @Test
  void endsTheRunWhenTheSimulatorIsUnavailable() throws IOException {
    suiteOf("5");
    Path world = Files.writeString(folder.resolve("w.world.yaml"), "mjcf: w.xml\n");
    String errors =
        errorsOf(
            () ->
                assertThat(
                        run(LifeCycle.CASE, "--bridge", "127.0.0.1:1", "--world", world.toString()))
                    .isEqualTo(3));
    assertThat(errors).startsWith("sitaf: simulator: opening the world w.world.yaml: UNAVAILABLE");
  }

  @Test
  void keepsResultsWhenTheComponentLeavesAnInterrupt() throws IOException {
    suiteOf("5", "98", "5");

    assertThat(run(LifeCycle.CASE)).isZero();
    assertThat(Thread.interrupted()).isTrue();
    assertThat(lines()).hasSize(3);
    assertThat(lines().get(2)).contains("outcome=\"RETURNED\"");
  }

  private static List<String> repeatedTimes(String line) {
    String times = line.replaceAll(".*<repeated_calls>(.*)</repeated_calls>.*", "$1");
    return List.of(times.split(" "));
  }

  @Test
  void repeatsEachCallWithANewComponent() throws IOException {
    suiteOf("5", "0", "x");

    assertThat(run(LifeCycle.CASE, "--repeat", "4", "--warm-up", "2")).isZero();
    assertThat(lines()).hasSize(3);
    assertThat(lines().get(0)).contains("outcome=\"RETURNED\"", "<actual name=\"return\">20<");
    assertThat(repeatedTimes(lines().get(0))).hasSize(4).allMatch(t -> t.matches("[0-9]+"));
    assertThat(lines().get(1)).contains("<thrown>ArithmeticException</thrown>");
    assertThat(repeatedTimes(lines().get(1))).hasSize(4);
    assertThat(lines().get(2)).contains("NOT_CALLED").doesNotContain("repeated_calls");
    assertThat(lines()).noneMatch(line -> line.contains("<differs>"));
    assertThat(Divider.LIFE).hasSize(2 * 14);
  }

  @Test
  void aRepeatedCallThatDiffersIsReportedAndDoesNotDecide() throws IOException {
    suiteOf("50");
    assertThat(run(LifeCycle.CASE, "--repeat", "6")).isZero();
    assertThat(lines().get(0))
        .contains("<actual name=\"return\">2</actual>")
        .contains("<differs>call 5: return is 0, not 2</differs></case_record>");
    assertThat(repeatedTimes(lines().get(0))).hasSize(6);

    Divider.LIFE.clear();
    suiteOf("51");
    assertThat(run(LifeCycle.CASE, "--repeat", "6")).isZero();
    assertThat(lines().get(0))
        .contains("outcome=\"RETURNED\"")
        .contains("<differs>call 5: threw IllegalStateException, but the first call returned<");
    assertThat(repeatedTimes(lines().get(0))).hasSize(3);
  }

  @Test
  void repeatsNoLongerThanTheGivenTime() throws IOException {
    suiteOf("5");
    assertThat(run(LifeCycle.CASE, "--repeat", "10000", "--repeat-within", "0.000000001")).isZero();
    assertThat(lines().get(0)).contains("<repeated_calls></repeated_calls>");
  }

  @Test
  void keepsResultsWhenTheProcessIsKilled() throws Exception {
    suiteOf("5", "4", "13", "5");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-cp",
                System.getProperty("java.class.path"),
                DividerDriver.class.getName(),
                "--suite",
                suite.toString(),
                "--results",
                results.toString())
            .inheritIO()
            .start();
    assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
    assertThat(process.exitValue()).isEqualTo(42);
    assertThat(lines()).hasSize(2);
    assertThat(lines().get(1)).startsWith("<case_record no=\"2\"").endsWith("</case_record>");
  }
}
