package org.sitaf.agent.toolchain.python.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.CompilationException;

/** Code of packages runs without network and can write only its output. */
@Tag("slow")
class HostilePackagesTest extends PackagesTest {
  @BeforeEach
  void requireSandbox() {
    assumeTrue(!sandbox.kind().equals(Sandbox.NONE), "skipped: bubblewrap is not available");
  }

  private Path make(List<String> lines, Path... wheels) throws Exception {
    return make(lines, List.of(wheels), null);
  }

  @Test
  void buildsASourceArchiveWithoutNetwork() throws Exception {
    Path outside = Files.createDirectories(directory.resolve("outside"));
    Path key = Files.writeString(directory.resolve("key"), "secret");
    String setup =
        """
        import glob, os, socket, sys
        observed = []
        for address in [("127.0.0.1", %d), ("169.254.169.254", 80)]:
            try:
                socket.create_connection(address, 2).close()
                observed.append("reached %%s" %% (address,))
            except OSError:
                observed.append("no network")
        for place in [%r, "/etc/evil", os.path.join(sys.prefix, "evil")]:
            try:
                open(place, "w").write("evil")
                observed.append("wrote " + place)
            except OSError:
                observed.append("not written")
        try:
            observed.append(open(%r).read())
        except OSError:
            observed.append("not read")
        for site in glob.glob(%r + "/*/environment/lib/python*/site-packages") + [p for p in sys.path if "site-packages" in p]:
            try:
                os.rename(os.path.join(site, "sitaf_runtime"), os.path.join(site, "gone"))
                os.symlink(%r, os.path.join(site, "sitaf_runtime"))
                observed.append("planted")
            except OSError:
                observed.append("not planted")
        open("sitaf_hostile_sample.py", "w").write("SAID = " + repr(observed) + "\\n")
        from setuptools import setup
        setup(name="sitaf-hostile-sample", version="1.0", py_modules=["sitaf_hostile_sample"],
              install_requires=["sitaf-hostile-needed"])
        """
            .replace("%r", "\"%s\"")
            .formatted(
                index.port(), outside.resolve("mark"), key, directory.resolve("cache"), outside);
    String top = "sitaf-hostile-sample-1.0/";
    index.add(
        "sitaf-hostile-sample",
        "sitaf-hostile-sample-1.0.zip",
        LocalIndex.zip(
            Map.of(
                top + "setup.py",
                setup,
                top + "PKG-INFO",
                "Metadata-Version: 2.1\nName: sitaf-hostile-sample\nVersion: 1.0\n")));
    index.add(
        "sitaf-hostile-needed",
        "sitaf_hostile_needed-1.0-py3-none-any.whl",
        LocalIndex.wheel("sitaf-hostile-needed", "THERE = True\n"));

    Path environment = make(List.of("sitaf-hostile-sample==1.0"));

    Path module = sitePackages(environment).resolve("sitaf_hostile_sample.py");
    assertThat(Files.readString(module))
        .contains("no network", "not written", "not read", "not planted")
        .doesNotContain("reached", "wrote", "secret", "'planted'");
    assertThat(outside).isEmptyDirectory();
    assertThat(sitePackages(environment).resolve("sitaf_hostile_needed.py")).isRegularFile();
    assertThat(
            Files.isDirectory(
                sitePackages(environment).resolve("sitaf_runtime"), LinkOption.NOFOLLOW_LINKS))
        .isTrue();
  }

  @Test
  void aWheelOfTheActivityCannotMakePipConnectToAnAddress() throws Exception {
    Path wheel =
        Files.write(
            directory.resolve("robot-1.0-py3-none-any.whl"),
            LocalIndex.wheel(
                "robot", "", "evil @ http://127.0.0.1:" + index.port() + "/evil-1.0.zip"));

    assertThatThrownBy(() -> make(List.of(), wheel))
        .isInstanceOfSatisfying(
            CompilationException.class,
            e ->
                assertThat(e.diagnostics().get(0).message())
                    .contains("requires 'evil @ http://127.0.0.1")
                    .contains("is not a package of the index"));
    assertThat(index.requests()).isEmpty();
  }

  // tests/e2e/test_libraries.py has the short form.
  @Test
  @Tag("long")
  void installsAWheelOfTheActivityWithItsRequirements() throws Exception {
    index.add(
        "sitaf-hostile-needed",
        "sitaf_hostile_needed-1.0-py3-none-any.whl",
        LocalIndex.wheel("sitaf-hostile-needed", "THERE = True\n"));
    Path wheel =
        Files.write(
            directory.resolve("robot-1.0-py3-none-any.whl"),
            LocalIndex.wheel(
                "robot", "MINE = True\n", "sitaf-hostile-needed", "pytest; extra == 'test'"));

    Path environment = make(List.of(), wheel);

    assertThat(sitePackages(environment).resolve("robot.py")).hasContent("MINE = True");
    assertThat(sitePackages(environment).resolve("sitaf_hostile_needed.py")).isRegularFile();
    assertThat(sitePackages(environment).resolve("pytest")).doesNotExist();
  }

  @Test
  void reportsAPackageThatIsNotInTheIndex() {
    assertThatThrownBy(() -> make(List.of("sitaf-hostile-nothing==9")))
        .isInstanceOfSatisfying(
            CompilationException.class,
            e ->
                assertThat(e.diagnostics().get(0).message())
                    .contains("No matching distribution found for sitaf-hostile-nothing==9"));
  }

  @Test
  void rejectsALinkInABuildFolder() throws Exception {
    Path folder = Files.createDirectories(directory.resolve("wheels"));
    Files.createSymbolicLink(folder.resolve("evil-1.0-py3-none-any.whl"), Path.of("/etc/passwd"));
    Files.createDirectory(folder.resolve("worse-1.0-py3-none-any.whl"));
    Path good = Files.writeString(folder.resolve("good-1.0-py3-none-any.whl"), "");

    assertThat(LocalWheel.wheelsIn(folder)).containsExactly(good);
  }
}
