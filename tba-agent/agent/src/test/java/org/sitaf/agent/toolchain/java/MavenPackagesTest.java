package org.sitaf.agent.toolchain.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;

/** Maven downloads packages from the configured repositories only. */
class MavenPackagesTest {
  @TempDir private Path directory;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "commons-math3",
        "org.apache.commons:commons-math3",
        "a:b:c:d",
        "a:b:[1,2)",
        "../../a:b:1",
        "a/b:c:1",
        "a:b:1</version></dependency>",
        "a:b:${user.home}",
        "a:b:1 -Dx=y",
        "http://127.0.0.1/:b:1",
        "-a:b:1"
      })
  void whatIsNotCoordinatesReachesNoMaven(String wanted) {
    Compilation compilation =
        new Compilation(
            EchoActivity.withBody("return value;").application(),
            directory,
            directory,
            directory.resolve("not-there"),
            Duration.ofSeconds(1),
            false,
            Sandbox.none());

    assertThatThrownBy(() -> new MavenPackages(directory).jars(wanted, compilation))
        .isInstanceOfSatisfying(
            CompilationException.class,
            e -> assertThat(e.diagnostics().get(0).message()).contains("is not a package such as"));
  }

  @Test
  void blocksRepositoriesOfAPackage() {
    assertThat(MavenPackages.settings(""))
        .contains("<mirrorOf>*,!central</mirrorOf>", "<blocked>true</blocked>");
  }

  @Test
  void keepsRepositoriesOfTheInstallation() {
    String installed =
        """
        <settings><profiles><profile><repositories>
          <repository><id>of-the-company</id><url>https://repo.example.com</url></repository>
        </repositories></profile></profiles></settings>
        """;

    assertThat(MavenPackages.settings(installed))
        .contains("<mirrorOf>*,!central,!of-the-company</mirrorOf>");
  }

  @Test
  void usesOnlyTheJarsOfAPackage() throws Exception {
    Path folder = Files.createDirectories(directory.resolve("resolved/a!b!1/a/b/1"));
    Files.createSymbolicLink(folder.resolve("link.jar"), Path.of("/etc/passwd"));
    Files.createDirectory(folder.resolve("folder.jar"));
    Files.writeString(folder.resolve("text.txt"), "");
    Path jar = Files.writeString(folder.resolve("b-1.jar"), "");
    Compilation compilation =
        new Compilation(
            EchoActivity.withBody("return value;").application(),
            directory,
            directory,
            directory,
            Duration.ofSeconds(1),
            false,
            Sandbox.none());

    assertThat(new MavenPackages(directory).jars("a:b:1", compilation))
        .containsExactly(new MavenPackages.Jar(jar, "a:b", "1"));
  }
}
