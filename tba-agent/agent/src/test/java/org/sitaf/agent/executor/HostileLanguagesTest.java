package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.Coverage.Line;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.Verdict;

/** Components in C++ and Python that hang or end the process, on the real runtimes. */
@Tag("slow")
@Timeout(600)
class HostileLanguagesTest {
  private static final String CPP =
      """
      #include <cstdlib>
      #include <iostream>

      namespace demo {

      class Component {
       public:
        int echo(int value);
      };

      }  // namespace demo
      """;

  private static final String CPP_BODY =
      """
      #include "component.hpp"

      int demo::Component::echo(int value) {
        volatile bool stuck = value == 2;
        while (stuck) {
        }
        if (value == 3) {
          std::cerr << "battery empty" << std::endl;
          std::exit(7);
        }
        return value;
      }
      """;

  private static final String PYTHON =
      """
      import os
      import sys


      class Component:
          def echo(self, value: int) -> int:
              while value == 2:
                  pass
              if value == 3:
                  print("battery empty", file=sys.stderr)
                  os._exit(7)
              return value
      """;

  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private TestResult result(EchoActivity activity) throws IOException {
    return ((Completed)
            new BuildRun(
                    activity.caseWallSeconds(2).generated(),
                    directory.resolve("build"),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    recording)
                .run())
        .result();
  }

  private static void isThere(Language language) {
    assumeTrue(
        EchoActivity.toolchains().of(language).isPresent(),
        () -> "skipped: " + EchoActivity.toolchains().missingMessage(language));
  }

  /** Case 2 hangs, case 3 ends the process, and the others have results. */
  private void assertOnlyOwnCasesFail(TestResult result, String where) {
    assertThat(result.cases())
        .extracting(CaseResult::verdict)
        .as(result.cases().toString())
        .containsExactly(Verdict.PASS, Verdict.ERROR, Verdict.ERROR, Verdict.PASS, Verdict.PASS);
    assertThat(result.cases().get(1).message())
        .as(recording.logText())
        .contains("no answer within 2 s, at ", where);
    assertThat(result.cases().get(2).message()).contains("exit code 7: battery empty");
  }

  private static void assertReached(TestResult result, String file, int line) {
    Coverage coverage = result.coverage();
    assertThat(coverage).isNotNull();
    assertThat(coverage.files()).extracting(Coverage.File::path).contains(file);
    assertThat(
            coverage.files().stream()
                .filter(f -> f.path().equals(file))
                .flatMap(f -> f.lines().stream())
                .filter(Line::reached)
                .map(Line::number))
        .contains(line);
  }

  @Test
  void aCppComponentFailsOnlyItsCases() throws Exception {
    isThere(Language.CPP);
    TestResult result =
        result(
            EchoActivity.inCpp("demo::Component")
                .file("component/component.hpp", CPP)
                .file("component/component.cpp", CPP_BODY));

    assertOnlyOwnCasesFail(result, "demo::Component::echo(int)");
    assertReached(result, "component/component.cpp", 11);
  }

  @Test
  void aPythonComponentFailsOnlyItsCases() throws Exception {
    isThere(Language.PYTHON);
    TestResult result =
        result(EchoActivity.inPython("component.Component").file("component/component.py", PYTHON));

    assertOnlyOwnCasesFail(result, "echo (component.py:");
    assertReached(result, "component/component.py", 12);
  }
}
