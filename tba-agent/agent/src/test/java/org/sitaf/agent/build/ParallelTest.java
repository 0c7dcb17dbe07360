package org.sitaf.agent.build;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome.Completed;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.TestResult;

/** Cases in several parallel simulations have the same results as in one. */
@Tag("slow")
class ParallelTest {
  private static final String BODY =
      "if (value == 7) { System.exit(4); } if (value == 31) { throw new Exception(\"no\"); }"
          + " return value == 23 ? 0 : value;";

  @TempDir private Path directory;
  private final Recording recording = new Recording();

  private TestResult result(String folder, EchoActivity activity) throws IOException {
    return ((Completed)
            new BuildRun(
                    activity.application(),
                    directory.resolve(folder),
                    EchoActivity.settings(SandboxMode.AUTO.open()),
                    recording)
                .run())
        .result();
  }

  /** All fields that do not depend on the clock. */
  private static List<String> summary(TestResult result) {
    return result.cases().stream().map(ParallelTest::summary).toList();
  }

  private static String summary(CaseResult c) {
    return c.no() + " " + c.verdict() + " " + c.values() + c.actual() + c.expected() + c.message();
  }

  @Test
  void resultsEqualThoseOfSequentialExecution() throws Exception {
    assumeTrue(Runtime.getRuntime().availableProcessors() > 1, "skipped: only one processor");
    TestResult sequence = result("sequence", EchoActivity.withBody(BODY).cases(40));
    TestResult parallel =
        result("parallel", EchoActivity.withBody(BODY).cases(40).profileLine("parallel: true"));

    assertThat(summary(parallel)).isEqualTo(summary(sequence));
    assertThat(parallel.summary().pass()).isEqualTo(37);
    assertThat(recording.logText()).contains("simulations in parallel");
    assertThat(parallel.coverage()).isEqualTo(sequence.coverage()).isNotNull();
  }
}
