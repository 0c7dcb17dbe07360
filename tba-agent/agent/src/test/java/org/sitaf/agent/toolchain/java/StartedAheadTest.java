package org.sitaf.agent.toolchain.java;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;

@Tag("slow")
@Timeout(300)
class StartedAheadTest {
  private static long compilers() {
    return ProcessHandle.current()
        .descendants()
        .filter(p -> p.info().arguments().map(StartedAheadTest::isCompiler).orElse(false))
        .count();
  }

  private static boolean isCompiler(String... arguments) {
    return String.join(" ", arguments).contains("CompilerMain");
  }

  /** Bubblewrap ends with the thread that started it. */
  @Test
  void theNextCompilerOutlivesTheThreadOfABuild() throws Exception {
    Toolchain toolchain = ((Found) JavaToolchain.find(EchoActivity.places())).toolchain();
    Sandbox sandbox = SandboxMode.AUTO.open();
    try {
      Thread build =
          new Thread(
              () -> {
                try {
                  toolchain.startAhead(sandbox);
                  // It runs on idle processors only, so a busy machine starts it late.
                  for (int i = 0; i < 400 && compilers() == 0; i++) {
                    Thread.sleep(100);
                  }
                  Thread.sleep(500);
                } catch (Exception e) {
                  throw new IllegalStateException(e);
                }
              });
      build.start();
      build.join();
      Thread.sleep(500);

      assertThat(compilers()).isPositive();
    } finally {
      toolchain.stop();
    }
  }
}
