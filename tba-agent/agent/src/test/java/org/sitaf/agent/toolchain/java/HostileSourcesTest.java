package org.sitaf.agent.toolchain.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Jars;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainLookup.Found;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.core.harness.TestApplication;

/** Hostile input of the Java compiler is not executed and does not harm the agent. */
@Tag("slow")
class HostileSourcesTest {
  @TempDir private Path directory;
  private List<Path> processors = List.of();
  private Toolchain toolchain = toolchain();

  private Toolchain toolchain() {
    ToolchainPlaces places = EchoActivity.places();
    return ((Found)
            JavaToolchain.find(
                new ToolchainPlaces(places.runtimes(), places.cache(), processors, null)))
        .toolchain();
  }

  @AfterEach
  void stop() {
    toolchain.stop();
  }

  private Path compile(EchoActivity activity, Sandbox sandbox, Duration atMost) throws Exception {
    TestApplication application = activity.application();
    Path build = Files.createTempDirectory(directory, "build");
    for (String path : application.files().paths()) {
      Path file = build.resolve("application").resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, application.files().content(path).orElseThrow());
    }
    Path output = Files.createDirectories(build.resolve("output"));
    toolchain.compile(
        new Compilation(
            application,
            build.resolve("application"),
            output,
            Files.createDirectories(build.resolve("scratch")),
            atMost,
            false,
            sandbox));
    return output;
  }

  private Path compile(EchoActivity activity) throws Exception {
    return compile(activity, SandboxMode.AUTO.open(), Duration.ofMinutes(2));
  }

  private CompilationException refused(EchoActivity activity) {
    return catchThrowableOfType(CompilationException.class, () -> compile(activity));
  }

  private void assertNextCompilationPasses() throws Exception {
    assertThat(compile(EchoActivity.withBody("return value;")).resolve("demo/Component.class"))
        .isRegularFile();
  }

  private static EchoActivity withLibrary(String body, Path jar) throws IOException {
    return EchoActivity.withBody(body)
        .file("lib/helper.jar", Files.readAllBytes(jar))
        .profileLine("libraries: [lib/helper.jar]");
  }

  private Path plugin(Path mark) throws IOException {
    return Jars.of(
        Files.createTempDirectory(directory, "plugin"),
        Map.of(
            "evil/Starter.java",
            """
            package evil;

            public final class Starter implements com.sun.source.util.Plugin {
              @Override public String getName() { return "evil"; }
              @Override public boolean autoStart() { return true; }
              @Override public void init(com.sun.source.util.JavacTask task, String... arguments) {
                try {
                  java.nio.file.Files.writeString(java.nio.file.Path.of("%s"), "evil");
                } catch (java.io.IOException e) {
                  throw new java.io.UncheckedIOException(e);
                }
              }
            }
            """
                .formatted(mark)),
        Map.of("META-INF/services/com.sun.source.util.Plugin", "evil.Starter\n"));
  }

  private Path processor() throws IOException {
    return Jars.of(
        Files.createTempDirectory(directory, "processor"),
        Map.of(
            "evil/Generator.java",
            """
            package evil;

            import javax.annotation.processing.*;
            import javax.lang.model.element.TypeElement;

            @SupportedAnnotationTypes("*")
            @SupportedSourceVersion(javax.lang.model.SourceVersion.RELEASE_17)
            public final class Generator extends AbstractProcessor {
              private boolean done;

              @Override public boolean process(
                  java.util.Set<? extends TypeElement> types, RoundEnvironment round) {
                if (!done) {
                  done = true;
                  try (var writer = processingEnv.getFiler()
                      .createSourceFile("demo.Generated").openWriter()) {
                    writer.write("package demo; class Generated { static final int ONE = 1; }");
                  } catch (java.io.IOException e) {
                    throw new java.io.UncheckedIOException(e);
                  }
                }
                return false;
              }
            }
            """),
        Map.of("META-INF/services/javax.annotation.processing.Processor", "evil.Generator\n"));
  }

  @Test
  void doesNotRunAutoStartPlugins() throws Exception {
    Path mark = directory.resolve("mark");
    Path jar = plugin(mark);
    // Tested without a sandbox, too, which would prevent writing.
    compile(withLibrary("return value;", jar), Sandbox.none(), Duration.ofMinutes(2));
    compile(withLibrary("return value;", jar));

    assertThat(mark).doesNotExist();
    assertThat(javacAlone(jar)).isZero();
    assertThat(mark).describedAs("javac itself starts it").exists();
  }

  private int javacAlone(Path jar) throws Exception {
    Path source = Files.writeString(directory.resolve("Plain.java"), "class Plain {}\n");
    String javac = Path.of(System.getProperty("java.home"), "bin", "javac").toString();
    return new ProcessBuilder(
            javac, "-proc:none", "-cp", jar.toString(), "-d", directory.toString(), "" + source)
        .inheritIO()
        .start()
        .waitFor();
  }

  @Test
  void doesNotRunAnnotationProcessorsOfTheClassPath() throws Exception {
    assertThat(refused(withLibrary("return Generated.ONE;", processor())).diagnostics())
        .anySatisfy(found -> assertThat(found.message()).contains("variable Generated"));
  }

  @Test
  void runsAnAllowedAnnotationProcessor() throws Exception {
    processors = List.of(processor());
    toolchain = toolchain();

    Path output = compile(EchoActivity.withBody("return Generated.ONE;"));

    assertThat(output.resolve("demo/Generated.class")).isRegularFile();
  }

  @Test
  void growingConstantsExceedTheMemoryOfTheCompiler() throws Exception {
    StringBuilder constants = new StringBuilder("package demo;\n\npublic class Component {\n");
    constants.append("  static final String C0 = \"").append("x".repeat(1000)).append("\";\n");
    for (int i = 1; i <= 21; i++) {
      String before = "C" + (i - 1);
      constants.append("  static final String C%d = %s + %s;\n".formatted(i, before, before));
    }
    constants.append("  public int echo(int value) { return value; }\n}\n");

    assertThat(refused(EchoActivity.withComponent(constants.toString())))
        .hasMessageContaining("the compiler used more than 1024 MiB of memory");
    assertNextCompilationPasses();
  }

  @Test
  void aDeepExpressionFailsOnlyTheCompilation() throws Exception {
    String deep = "(".repeat(200_000) + "value" + ")".repeat(200_000);

    assertThat(refused(EchoActivity.withBody("return " + deep + ";")))
        .hasMessageContaining("simplify the sources");
    assertNextCompilationPasses();
  }

  @Test
  void stopsACompilationThatNeverEnds() throws Exception {
    // The type of the value doubles with each call.
    String endless = "pair(".repeat(40) + "value" + ")".repeat(40);
    EchoActivity activity =
        EchoActivity.withComponent(
            """
            package demo;

            public class Component {
              static class Pair<A, B> {}
              static <T> Pair<T, T> pair(T t) { return null; }
              public int echo(int value) {
                var x = %s;
                var y = x;
                x = y;
                return value;
              }
            }
            """
                .formatted(endless));

    assertThat(
            catchThrowableOfType(
                CompilationException.class,
                () -> compile(activity, SandboxMode.AUTO.open(), Duration.ofSeconds(5))))
        .hasMessage("the compilation did not finish within 5 s");
    assertNextCompilationPasses();
  }

  @Test
  void aHugeClassExceedsTheMemoryOfTheCompiler() throws Exception {
    Path jar = Jars.bomb(directory.resolve("bomb.jar"), "demo/Helper.class", 1200);

    assertThat(refused(withLibrary("return Helper.help(value);", jar)).getMessage())
        .containsAnyOf("the compiler used more than 1024 MiB", "bad class file");
    assertNextCompilationPasses();
  }

  @Test
  void aManifestCannotReferToFilesOutside() throws Exception {
    Path secret =
        Jars.of(
            directory.resolve("secret"),
            Map.of("secret/Key.java", "package secret; public class Key { public int k = 1; }"),
            Map.of());
    Path naming = Jars.naming(directory.resolve("naming.jar"), secret.toUri().toString());

    assertThat(refused(withLibrary("return new secret.Key().k;", naming)).getMessage())
        .contains("package secret does not exist");
  }

  @Test
  void reportsAFileThatIsNotAJar() {
    assertThat(
            refused(
                EchoActivity.withComponent("package demo; class Other {}")
                    .file("lib/helper.jar", "no jar")
                    .profileLine("libraries: [lib/helper.jar]")))
        .hasMessage("helper.jar is not a jar");
  }

  @Test
  void reportsAResourceWithTheNameOfAFolder() {
    assertThat(
            refused(
                EchoActivity.withBody("return value;")
                    .profileLine("harness: java")
                    .file("component/sitaf", "")))
        .hasMessage("the component's files conflict");
  }

  @Test
  void aCompilerStartedAheadServesOneCompilation() throws Exception {
    Path compilers = EchoActivity.places().cache().resolve("java/compilers");
    toolchain.startAhead(SandboxMode.AUTO.open());
    long ahead = own(compilers);
    assertNextCompilationPasses();

    assertThat(ahead).isEqualTo(1);
    assertThat(own(compilers)).isZero();
    assertNextCompilationPasses();
    assertThat(own(compilers)).isZero();
  }

  private static long own(Path compilers) throws IOException {
    String prefix = ProcessHandle.current().pid() + "-";
    try (Stream<Path> folders = Files.list(compilers)) {
      return folders.filter(path -> path.getFileName().toString().startsWith(prefix)).count();
    }
  }
}
