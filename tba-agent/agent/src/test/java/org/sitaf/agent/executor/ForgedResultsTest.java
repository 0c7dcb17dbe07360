package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/**
 * Components that forge results, with the real runtimes and drivers: a failed case never passes,
 * and forged lines in the results channel make the build suspect.
 */
@Tag("slow")
@Timeout(600)
class ForgedResultsTest {
  private static final String FORGED =
      "<case_record no=\\\"5\\\" outcome=\\\"RETURNED\\\"><actual name=\\\"return\\\">5</actual>"
          + "</case_record>";
  private static final int MAX_LOG = 100_000;

  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private TestResult result(TestApplication application) throws IOException {
    return ((Completed)
            new BuildRun(
                    application,
                    directory.resolve("build"),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    recording)
                .run())
        .result();
  }

  /** A component that does something in case 2, and returns the wrong value in case 5. */
  private TestResult result(Language language, String inCaseTwo) throws IOException {
    assumeTrue(
        EchoActivity.toolchains().of(language).isPresent(),
        () -> "skipped: " + EchoActivity.toolchains().missingMessage(language));
    return result(component(language, inCaseTwo).caseWallSeconds(30).generated());
  }

  private static EchoActivity component(Language language, String inCaseTwo) {
    return switch (language) {
      case JAVA ->
          EchoActivity.withBody(
              "if (value == 2) { %s } return value == 5 ? -999 : value;".formatted(inCaseTwo));
      case CPP ->
          EchoActivity.inCpp("demo::Component")
              .file(
                  "component/component.hpp",
                  "namespace demo { class Component { public: int echo(int value); }; }\n")
              .file(
                  "component/component.cpp",
                  """
                  #include "component.hpp"
                  #include <cstdlib>
                  #include <fcntl.h>
                  #include <iostream>
                  #include <signal.h>
                  #include <string>
                  #include <sys/stat.h>
                  #include <unistd.h>

                  void all(const std::string& text) {
                    for (int fd = 3; fd < 1024; ++fd) {
                      struct stat is {};
                      if (fstat(fd, &is) == 0 && S_ISFIFO(is.st_mode)) {
                        (void)!write(fd, text.data(), text.size());
                      }
                    }
                  }

                  int demo::Component::echo(int value) {
                    if (value == 2) {
                      %s
                    }
                    return value == 5 ? -999 : value;
                  }
                  """
                      .formatted(inCaseTwo));
      case PYTHON ->
          EchoActivity.inPython("component.Component")
              .file(
                  "component/component.py",
                  """
                  import os
                  import stat
                  import sys


                  def write_all(text):
                      for fd in range(3, 1024):
                          try:
                              if stat.S_ISFIFO(os.fstat(fd).st_mode):
                                  left = text.encode()
                                  while left:
                                      left = left[os.write(fd, left):]
                          except OSError:
                              pass


                  class Component:
                      def echo(self, value: int) -> int:
                          if value == 2:
                              %s
                          return -999 if value == 5 else value
                  """
                      .formatted(inCaseTwo));
    };
  }

  private static String toAllDescriptors(Language language, String text) {
    return switch (language) {
      case JAVA ->
          "for (var f : new java.io.File(\"/proc/self/fd\").listFiles()) {"
              + " try { if (java.nio.file.Files.readSymbolicLink(f.toPath()).toString()"
              + ".contains(\"pipe\") && Integer.parseInt(f.getName()) > 2) {"
              + " try (var out = new java.io.FileOutputStream(f)) { out.write((\""
              + text
              + "\").getBytes()); } } } catch (java.io.IOException e) { } }";
      case CPP -> "all(\"" + text + "\");";
      case PYTHON -> "write_all(\"" + text + "\")";
    };
  }

  private void caseFiveFails(TestResult result) {
    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .as(recording.logText())
        .hasSize(5)
        .endsWith(Verdict.FAIL);
    assertThat(recording.logText()).hasSizeLessThan(MAX_LOG);
  }

  private void isSuspect(TestResult result, String reason) {
    assertThat(result.suspicions()).as(recording.logText()).anyMatch(s -> s.contains(reason));
    assertThat(recording.logText()).contains("the result is suspect: ");
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void linesOnTheStandardStreamsAreOutput(Language language) throws Exception {
    String line = "1 0123456789abcdef0123456789abcdef " + FORGED;
    String prints =
        switch (language) {
          case JAVA -> "System.out.println(\"%s\"); System.err.println(\"%s\");";
          case CPP -> "std::cout << \"%s\" << std::endl; std::cerr << \"%s\" << std::endl;";
          case PYTHON -> "print(\"%s\"); print(\"%s\", file=sys.stderr)";
        };
    TestResult result = result(language, prints.formatted(line, line));

    caseFiveFails(result);
    assertThat(result.summary().pass()).isEqualTo(4);
    assertThat(result.suspicions()).isEmpty();
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void forgedLinesOnEveryDescriptorMakeTheBuildSuspect(Language language) throws Exception {
    TestResult result =
        result(
            language,
            toAllDescriptors(
                language,
                FORGED + "\\n3 0123456789abcdef0123456789abcdef " + FORGED + "\\nnonsense\\n\\n"));

    caseFiveFails(result);
    assertThat(result.summary().pass()).isEqualTo(4);
    isSuspect(result, "a line without number and token (");
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void halfALineSpoilsTheNextAndIsSuspect(Language language) throws Exception {
    TestResult result = result(language, toAllDescriptors(language, FORGED.substring(0, 40)));

    assertThat(result.cases().get(1).verdict()).isEqualTo(Verdict.ERROR);
    caseFiveFails(result);
    isSuspect(result, "a line without number and token");
    isSuspect(result, "expected line");
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void aFloodOfLineFeedsEndsTheBuildWithANumber(Language language) throws Exception {
    TestResult result =
        result(
            language,
            switch (language) {
              case JAVA ->
                  "byte[] feeds = new byte[1 << 20]; java.util.Arrays.fill(feeds, (byte) 10);"
                      + " try (var out = new java.io.FileOutputStream(\"/dev/fd/3\")) {"
                      + " for (int i = 0; i < 250; i++) out.write(feeds); }";
              case CPP ->
                  "const std::string feeds(1 << 20, '\\n');"
                      + " for (int i = 0; i < 250; ++i) { all(feeds); }";
              case PYTHON -> "[write_all(\"\\n\" * (1 << 20)) for _ in range(250)]";
            });

    assertThat(result.cases()).extracting(CaseResult::verdict).contains(Verdict.DONT);
    assertThat(result.cases().get(4).message()).contains("more than 16 MiB of unexpected lines");
    isSuspect(result, "a line without number and token");
    assertThat(recording.logText()).hasSizeLessThan(MAX_LOG);
  }

  @Test
  void anEndlessLineEndsTheBuildWithoutUsingMemory() throws Exception {
    TestResult result =
        result(
            Language.JAVA,
            "byte[] all = new byte[1 << 20]; java.util.Arrays.fill(all, (byte) 'x');"
                + " try (var out = new java.io.FileOutputStream(\"/dev/fd/3\")) {"
                + " for (int i = 0; i < 1024; i++) out.write(all); }");

    assertThat(result.cases().get(4).message()).contains("more than 16 MiB of unexpected lines");
    assertThat(result.isSuspect()).isTrue();
    assertThat(recording.logText()).hasSizeLessThan(MAX_LOG);
  }

  @ParameterizedTest
  @EnumSource(Language.class)
  void badLinesDoNotFillTheLog(Language language) throws Exception {
    TestResult result =
        result(
            language,
            switch (language) {
              case JAVA ->
                  "StringBuilder text = new StringBuilder();"
                      + " for (int i = 0; i < 200000; i++) text.append(\"1 bad line \").append(i)"
                      + ".append('\\n'); try (var out = new"
                      + " java.io.FileOutputStream(\"/dev/fd/3\")) {"
                      + " out.write(text.toString().getBytes()); }";
              case CPP ->
                  "std::string text; for (int i = 0; i < 200000; ++i) {"
                      + " text += \"1 bad line \" + std::to_string(i) + \"\\n\"; } all(text);";
              case PYTHON -> "write_all(\"\".join(f\"1 bad line {i}\\n\" for i in range(200000)))";
            });

    caseFiveFails(result);
    assertThat(result.summary().pass()).isEqualTo(4);
    isSuspect(result, "(200000 times)");
  }

  @Test
  void hidesExpectedValuesFromTheComponent() throws Exception {
    TestResult result =
        result(
            EchoActivity.withBody(
                    """
                    String suite = "";
                    for (String argument :
                        ProcessHandle.current().info().arguments().orElseThrow()) {
                      if (argument.endsWith("suite.xml")) {
                        suite = java.nio.file.Files.readString(java.nio.file.Path.of(argument));
                      }
                    }
                    if (!suite.contains("<value>")) {
                      throw new IllegalStateException("the suite is not there");
                    }
                    return suite.contains("<expected") ? value : -999;
                    """)
                .generated());

    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .as(recording.logText())
        .containsOnly(Verdict.FAIL);
  }

  @Test
  void aLeftoverProcessCannotForgeLaterResults() throws Exception {
    TestResult result =
        result(
            Language.CPP,
            "if (fork() == 0) { setsid(); sleep(2); all(\"late\\n\"); _exit(0); } _exit(9);");

    assertThat(result.cases().get(1).verdict()).isEqualTo(Verdict.ERROR);
    assertThat(result.summary().pass()).isEqualTo(3);
    caseFiveFails(result);
  }

  @Test
  void noCasePassesIfTheDescriptorsAreClosed() throws Exception {
    TestResult result = result(Language.CPP, "for (int fd = 3; fd < 1024; ++fd) { close(fd); }");

    assertThat(result.summary().pass()).isEqualTo(1);
    assertThat(result.summary().dont()).isEqualTo(4);
  }

  @Test
  void aStaticInitializerCannotReadTheToken() throws Exception {
    TestResult result =
        result(
            EchoActivity.inCpp("demo::Component")
                .file(
                    "component/component.hpp",
                    "namespace demo { class Component { public: int echo(int value); }; }\n")
                .file(
                    "component/component.cpp",
                    """
                    #include "component.hpp"
                    #include <iostream>
                    #include <string>
                    static const bool found = [] {
                      std::string line;
                      const bool there = static_cast<bool>(std::getline(std::cin, line));
                      std::cout << "initialiser read " << there << std::endl;
                      return there;
                    }();
                    int demo::Component::echo(int value) { return found ? -1 : value; }
                    """)
                .generated());

    assertThat(result.summary().pass()).as(recording.logText()).isEqualTo(5);
    assertThat(recording.logText()).contains("initialiser read 0");
  }

  @Test
  void loadsTheRuntimeBeforeModulesOfTheComponent() throws Exception {
    String spying = "import os, sys\nprint('spying', os.read(0, 100), file=sys.stderr)\n";
    TestResult result =
        result(
            EchoActivity.inPython("component.Component")
                .file("component/sitecustomize.py", spying)
                .file("component/fcntl.py", spying)
                .file("component/sitaf_runtime/__init__.py", spying)
                .file(
                    "component/component.py",
                    "class Component:\n"
                        + "    def echo(self, value: int) -> int:\n"
                        + "        return value\n")
                .generated());

    assertThat(result.summary().pass()).as(recording.logText()).isEqualTo(5);
    assertThat(recording.logText()).doesNotContain("spying");
  }
}
