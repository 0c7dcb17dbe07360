package org.sitaf.agent.compiler;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.spool.SharedCache;
import org.sitaf.agent.spool.SystemTool;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.harness.TestApplication;

/** Compiles changed inputs only. */
class CompileCacheTest {
  @TempDir private Path directory;

  /** Counts the calls; the compiled file contains the number of the call. */
  private static final class CountingToolchain implements Toolchain {
    private final String identity;
    private int compiled;

    CountingToolchain(String identity) {
      this.identity = identity;
    }

    @Override
    public Language language() {
      return Language.JAVA;
    }

    @Override
    public String version() {
      return "counting 1";
    }

    @Override
    public String identity() {
      return identity;
    }

    @Override
    public void compile(Compilation compilation) throws IOException {
      Path folder = Files.createDirectories(compilation.output().resolve("folder"));
      Files.writeString(folder.resolve("program"), "" + ++compiled);
    }

    @Override
    public CompiledApplication open(Compilation compilation) {
      return new CompiledApplication() {
        @Override
        public java.util.List<String> command(org.sitaf.agent.toolchain.ProcessPlace place) {
          return java.util.List.of(compilation.output().resolve("folder/program").toString());
        }

        @Override
        public java.util.List<Path> readable() {
          return java.util.List.of(compilation.output());
        }
      };
    }
  }

  private String compile(Toolchain toolchain, TestApplication application, boolean coverage)
      throws Exception {
    Path build = Files.createTempDirectory(directory, "build");
    TestApplicationCompiler compiler =
        new TestApplicationCompiler(
            toolchain, directory.resolve("cache"), coverage, Sandbox.none());
    CompiledApplication compiled =
        compiler.compile(compiler.begin(application, build.resolve("application"), build));
    return Files.readString(compiled.readable().get(0).resolve("folder/program"));
  }

  @Test
  void compilesEqualInputsOnce() throws Exception {
    CountingToolchain toolchain = new CountingToolchain("a");

    assertThat(compile(toolchain, EchoActivity.withBody("return value;").application(), false))
        .isEqualTo("1");
    assertThat(compile(toolchain, EchoActivity.withBody("return value;").application(), false))
        .isEqualTo("1");
    assertThat(toolchain.compiled).isEqualTo(1);
  }

  @Test
  void doesNotCompileForOtherCasesOfTheSameModel() throws Exception {
    CountingToolchain toolchain = new CountingToolchain("a");
    TestApplication first = EchoActivity.withBody("return value;").application();
    compile(toolchain, first, false);
    TestApplication fewer =
        new TestApplication(
            first.activity(),
            first.model(),
            new org.sitaf.core.suite.TestSuite(
                first.suite().name(),
                "",
                first.suite().modelName(),
                first.suite().generation(),
                first.suite().parameters(),
                first.suite().cases().subList(0, 1)),
            first.harness(),
            first.entryPoint());

    assertThat(compile(toolchain, fewer, false)).isEqualTo("1");
  }

  @Test
  void recompilesAfterAChangeOfSourceToolchainOrCoverage() throws Exception {
    CountingToolchain toolchain = new CountingToolchain("a");
    CountingToolchain later = new CountingToolchain("b");
    TestApplication application = EchoActivity.withBody("return value;").application();
    compile(toolchain, application, false);

    compile(toolchain, EchoActivity.withBody("return  value;").application(), false);
    compile(toolchain, application, true);
    compile(later, application, false);

    assertThat(toolchain.compiled).isEqualTo(3);
    assertThat(later.compiled).isEqualTo(1);
  }

  @Test
  void removesTheLeastRecentlyUsedEntry() throws Exception {
    CompileCache cache = cache(25);
    Path output = Files.createDirectories(directory.resolve("output"));
    Files.writeString(output.resolve("program"), "0123456789");
    for (int i = 0; i < 3; i++) {
      cache.keep(key(i), output);
      Files.setLastModifiedTime(
          directory.resolve("cache").resolve(key(i)),
          FileTime.from(Instant.now().minusSeconds(i == 0 ? 5 : 100 - i)));
    }
    cache.keep(key(3), output);

    assertThat(restores(cache, 0)).isTrue();
    assertThat(restores(cache, 1)).isFalse();
    assertThat(restores(cache, 2)).isFalse();
    assertThat(restores(cache, 3)).isTrue();
  }

  @Test
  void severalProcessesMayAddTheSameEntry() throws Exception {
    CompileCache cache = cache(1 << 20);
    Path output = Files.createDirectories(directory.resolve("output"));
    Files.writeString(output.resolve("program"), "0123456789");

    CompletableFuture.allOf(
            IntStream.range(0, 16)
                .mapToObj(
                    i ->
                        CompletableFuture.runAsync(
                            () -> {
                              try {
                                cache.keep(key(i % 2), output);
                              } catch (IOException e) {
                                throw new java.io.UncheckedIOException(e);
                              }
                            }))
                .toArray(CompletableFuture[]::new))
        .get();

    assertThat(restores(cache, 0)).isTrue();
    assertThat(restores(cache, 1)).isTrue();
    try (var left = Files.list(directory.resolve("cache"))) {
      assertThat(left).hasSize(2);
    }
  }

  @Test
  void removesDraftsOfKilledProcesses() throws Exception {
    Path folder = directory.resolve("cache");
    Path killed = aside(folder, "new123", 61);
    Path killedWhileRemoving = aside(folder, "old123", 61);
    Path incomplete = aside(folder, "new456", 59);
    Path kept = aside(folder, key(1), 600);
    Path output = Files.createDirectories(directory.resolve("output"));
    cache(1 << 20).keep(key(0), output);

    assertThat(killed).doesNotExist();
    assertThat(killedWhileRemoving).doesNotExist();
    assertThat(incomplete.resolve("folder/program")).exists();
    assertThat(kept.resolve("folder/program")).exists();
  }

  private static Path aside(Path cache, String name, int minutesAgo) throws IOException {
    Path folder = cache.resolve(name);
    Files.writeString(Files.createDirectories(folder.resolve("folder")).resolve("program"), "1");
    Files.setLastModifiedTime(
        folder, FileTime.from(Instant.now().minus(Duration.ofMinutes(minutesAgo))));
    return folder;
  }

  @Test
  void rejectsAPathAsKey() {
    CompileCache cache = cache(1);

    assertThatThrownBy(() -> cache.restore("../x", directory, folder -> true))
        .isInstanceOf(IllegalArgumentException.class);
  }

  private CompileCache cache(long limitBytes) {
    return new CompileCache(new SharedCache(directory.resolve("cache")), limitBytes);
  }

  private boolean restores(CompileCache cache, int i) throws IOException {
    Path into = Files.createTempDirectory(directory, "into");
    boolean restored = cache.restore(key(i), into, folder -> true);
    assertThat(Files.exists(into.resolve("program"))).isEqualTo(restored);
    return restored;
  }

  private static String key(int i) {
    return Integer.toString(i).repeat(64);
  }

  @Test
  void rejectsFilesThatNoCompilerWrites() throws Exception {
    Path secret = Files.writeString(directory.resolve("secret"), "the agent's key");
    CompileCache cache = new CompileCache(new SharedCache(directory.resolve("odd")), 1 << 20);
    Path output = Files.createDirectory(directory.resolve("output"));
    Files.writeString(output.resolve("program"), "p");
    Files.createSymbolicLink(output.resolve("link"), Path.of("program"));
    String key = "a".repeat(64);
    cache.keep(key, output);
    Path restored = Files.createDirectory(directory.resolve("restored"));
    assertThat(cache.restore(key, restored, compiled -> true)).isTrue();
    assertThat(restored.resolve("link")).hasContent("p");

    Files.createSymbolicLink(output.resolve("outside"), secret);
    cache.keep("b".repeat(64), output);
    Files.delete(output.resolve("outside"));
    SystemTool.run(List.of("mkfifo", output.resolve("pipe").toString()), Duration.ofSeconds(5));
    cache.keep("c".repeat(64), output);

    assertThat(cache.restore("b".repeat(64), restored, compiled -> true)).isFalse();
    assertThat(cache.restore("c".repeat(64), restored, compiled -> true)).isFalse();
  }
}
