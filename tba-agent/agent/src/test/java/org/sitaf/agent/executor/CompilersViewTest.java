package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.BuildOutcome;
import org.sitaf.agent.build.BuildOutcome.CompilationFailed;
import org.sitaf.agent.build.BuildRun;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.testing.Recording;
import org.sitaf.core.activity.ActivityProfile.Language;

/** Compilers cannot include files of the agent or of other users. */
@Tag("slow")
@Timeout(300)
class CompilersViewTest {
  @TempDir private Path directory;
  private Path key = Path.of("key");
  private Sandbox sandbox = Sandbox.none();

  @BeforeEach
  void prepare() throws Exception {
    sandbox = SandboxMode.AUTO.open();
    assumeTrue(!sandbox.kind().equals(Sandbox.NONE), "skipped: bubblewrap is not available");
    key = Files.writeString(directory.resolve("key"), "sitaf_secret_of_the_agent");
  }

  private String logOf(EchoActivity activity) {
    Recording recording = new Recording();
    BuildOutcome outcome =
        new BuildRun(
                activity.generated(),
                directory.resolve("build"),
                EchoActivity.settings(sandbox),
                recording)
            .run();
    assertThat(outcome).describedAs(recording.logText()).isInstanceOf(CompilationFailed.class);
    return recording.logText();
  }

  private EchoActivity inCpp(String statement) {
    assumeTrue(
        EchoActivity.toolchains().of(Language.CPP).isPresent(),
        () -> "skipped: " + EchoActivity.toolchains().missingMessage(Language.CPP));
    return EchoActivity.inCpp("demo::Component")
        .file(
            "component/component.hpp",
            "namespace demo { class Component { public: int echo(int value); }; }\n")
        .file(
            "component/component.cpp",
            "#include \"component.hpp\"\n"
                + statement
                + "\nint demo::Component::echo(int value) { return value; }\n");
  }

  @Test
  void aCppIncludeCannotReadFilesOfTheAgent() {
    assertThat(logOf(inCpp("#include \"" + key + "\"")))
        .contains("No such file or directory")
        .doesNotContain("sitaf_secret_of_the_agent");
  }

  @Test
  void anAssemblerIncludeCannotReadFilesOfTheAgent() {
    assertThat(logOf(inCpp("asm(\".section .rodata\\n.incbin \\\"" + key + "\\\"\\n.text\");")))
        .contains("file not found")
        .doesNotContain("sitaf_secret_of_the_agent");
  }

  @Test
  void aPragmaCannotLoadAPlugin() {
    // Neither the profile nor a pragma can pass compiler options.
    assertThat(logOf(inCpp("#pragma GCC optimize (\"-fplugin=/tmp/evil.so\")\n#error the end")))
        .contains("the end")
        .doesNotContain("evil.so: cannot open");
  }

  @Test
  void compilingPythonExecutesNoCode() throws Exception {
    assumeTrue(EchoActivity.toolchains().of(Language.PYTHON).isPresent(), "skipped: no Python");
    String log =
        logOf(
            EchoActivity.inPython("component.Component")
                .file(
                    "component/component.py",
                    "print('i ran')\nopen('%s', 'w').write('evil')\n\nclass Component:\n  x = =\n"
                        .formatted(key))
                .file("component/sitecustomize.py", "print('i ran')\n")
                .file("component/py_compile.py", "print('i ran')\n"));

    assertThat(log).contains("component.py:5").doesNotContain("i ran");
    assertThat(key).hasContent("sitaf_secret_of_the_agent");
  }
}
