package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

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

/**
 * The log attributes output to cases, for all languages and ways of printing. The order of the two
 * streams is undefined.
 */
@Tag("slow")
@Timeout(300)
class CaseOutputTest {
  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private String logOf(EchoActivity activity) throws Exception {
    assertThat(
            new BuildRun(
                    activity.generated(),
                    directory.resolve("build"),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    recording)
                .run())
        .isInstanceOf(Completed.class);
    return recording.logText();
  }

  private static void isThere(Language language) {
    assumeTrue(
        EchoActivity.toolchains().of(language).isPresent(),
        () -> "skipped: " + EchoActivity.toolchains().missingMessage(language));
  }

  @Test
  void coverageOfAJavaComponent() throws Exception {
    String log =
        logOf(
            EchoActivity.withBody(
                """
                if (value == 2) {
                  System.out.print("two é");
                }
                if (value == 4) {
                  System.err.println("four");
                }
                return value;
                """));
    assertThat(log).contains("[sitaf] case 2\ntwo é", "[sitaf] case 4\nfour\n");
    assertThat(log).doesNotContain("[sitaf] case 3", "\u001e");
  }

  @Test
  void coverageOfAPythonComponent() throws Exception {
    isThere(Language.PYTHON);
    String log =
        logOf(
            EchoActivity.inPython("component.Component")
                .file(
                    "component/component.py",
                    """
                    import sys


                    class Component:
                        def echo(self, value: int) -> int:
                            if value == 2:
                                print("two é")
                            if value == 4:
                                print("four", file=sys.stderr)
                            return value
                    """));
    assertThat(log).contains("[sitaf] case 2\ntwo é", "[sitaf] case 4\nfour\n");
    assertThat(log).doesNotContain("[sitaf] case 3", "\u001e");
  }

  @Test
  void coverageOfACppComponent() throws Exception {
    isThere(Language.CPP);
    String log =
        logOf(
            EchoActivity.inCpp("demo::Component")
                .file(
                    "component/component.hpp",
                    """
                    namespace demo {
                    class Component {
                     public:
                      int echo(int value);
                    };
                    }  // namespace demo
                    """)
                .file(
                    "component/component.cpp",
                    """
                    #include "component.hpp"
                    #include <cstdio>
                    #include <iostream>

                    int demo::Component::echo(int value) {
                      if (value == 1) {
                        std::ios::sync_with_stdio(false);
                      }
                      if (value == 2) {
                        std::cout << "two é ";
                        std::printf("and two");
                      }
                      if (value == 4) {
                        std::cerr << "four" << std::endl;
                      }
                      if (value == 5) {
                        std::fprintf(stderr, "five %d\\n", value);
                      }
                      return value;
                    }
                    """));
    assertThat(log)
        .contains(
            "[sitaf] case 2\ntwo é and two", "[sitaf] case 4\nfour\n", "[sitaf] case 5\nfive 5\n");
    assertThat(log).doesNotContain("[sitaf] case 3", "\u001e");
  }
}
