package org.sitaf.agent.toolchain.python.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.python.environment.WheelCollection.PackageException;

/** pip gets packages of the index only. */
class RequirementsTest {
  @TempDir private Path activity;

  private Requirements read(String list) throws Exception {
    Files.createDirectories(activity.resolve("component"));
    Files.writeString(activity.resolve("component/requirements.txt"), list);
    return Requirements.of(
        EchoActivity.inPython("demo.Component")
            .file("component/demo.py", "")
            .application()
            .activity()
            .profile(),
        null,
        activity);
  }

  @Test
  void acceptsExtrasVersionsAndMarkers() throws Exception {
    assertThat(
            read("""
                    # what it needs
                    simple-pid==2.0.1
                    numpy >= 1.26, < 3   # arrays
                    ruamel.yaml[jinja2]~=0.18

                    tomli>=2; python_version < "3.11"
                    """)
                .lines())
        .isEqualTo(
            List.of(
                "simple-pid==2.0.1",
                "numpy >= 1.26, < 3",
                "ruamel.yaml[jinja2]~=0.18",
                "tomli>=2; python_version < \"3.11\""));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "-r other.txt",
        "-c constraints.txt",
        "-e .",
        "--index-url http://169.254.169.254/",
        "--extra-index-url=http://127.0.0.1:8080/simple",
        "--find-links /",
        "--trusted-host evil",
        "-i http://127.0.0.1/",
        "evil @ http://169.254.169.254/latest/meta-data",
        "evil@file:///etc/passwd",
        "git+https://example.com/evil.git",
        "http://127.0.0.1:9090/evil-1.0.tar.gz",
        "file:///etc/passwd",
        "./evil",
        "../evil",
        "/root/evil",
        "evil/setup",
        "evil-1.0-py3-none-any.whl",
        "evil-1.0.tar.gz",
        "evil.zip",
        "evil==1.0 --hash=sha256:00",
        "evil==1.0 --config-settings=x=y",
        "evil==${HOME}",
        "evil\\",
        "evil; $(id)",
        "evil`id`",
        "evil\u0000",
        "éevil"
      })
  void everythingElseIsRefusedWithItsLine(String line) {
    assertThatThrownBy(() -> read("simple-pid==2.0.1\n" + line + "\n"))
        .isInstanceOfSatisfying(
            CompilationException.class,
            e -> {
              assertThat(e.diagnostics().get(0).file())
                  .isEqualTo("activity/component/requirements.txt");
              assertThat(e.diagnostics().get(0).line()).isEqualTo(2);
              assertThat(e.diagnostics().get(0).message())
                  .contains("is not a package of the index such as simple-pid==2.0.1");
            });
  }

  @Test
  void rejectsAnUnterminatedList() {
    assertThatThrownBy(() -> read("a\n".repeat(201))).isInstanceOf(CompilationException.class);
    assertThatThrownBy(() -> read("#".repeat(70_000))).isInstanceOf(CompilationException.class);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "evil @ http://127.0.0.1:9090/evil-1.0.tar.gz",
        "evil @ file:///etc",
        "--index-url http://127.0.0.1",
        "evil.whl"
      })
  void whatAWheelRequiresIsHeldToTheSame(String requirement) {
    assertThatThrownBy(() -> LocalWheel.requirement(requirement, "robot"))
        .isInstanceOf(PackageException.class)
        .hasMessageContaining("which is not a package of the index");
  }

  @Test
  void readsRequirementsOfOldWheelsAndExtras() throws Exception {
    assertThat(LocalWheel.requirement("numpy (>=1.20)", "robot")).containsExactly("numpy  >=1.20");
    assertThat(LocalWheel.requirement("pytest; extra == 'test'", "robot")).isEmpty();
    assertThat(LocalWheel.requirement("tomli>=2; python_version < '3.11'", "robot"))
        .containsExactly("tomli>=2 ; python_version < '3.11'");
  }
}
