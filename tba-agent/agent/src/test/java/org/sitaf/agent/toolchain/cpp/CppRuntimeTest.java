package org.sitaf.agent.toolchain.cpp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.core.activity.ActivityProfile.Language;

@Tag("slow")
class CppRuntimeTest {
  @TempDir private Path directory;

  @Test
  void whatAnEarlierCacheHasIsNotCompiledAgain() throws Exception {
    assumeTrue(
        EchoActivity.toolchains().of(Language.CPP).isPresent(),
        () -> "skipped: " + EchoActivity.toolchains().missingMessage(Language.CPP));
    Compiler compiler = Compiler.of(Tools.find("g++").orElseThrow());
    Path sources = EchoActivity.places().runtimes().resolve("runtime-cpp");
    Path earlier = EchoActivity.places().cache().resolve("cpp").resolve("runtime");
    new CppRuntime(compiler, sources, earlier, null).build();
    Path own = directory.resolve("own");

    CppRuntime.Built built = new CppRuntime(compiler, sources, own, earlier).build();

    assertThat(built.library()).startsWith(earlier).isDirectory();
    assertThat(own).doesNotExist();
  }
}
