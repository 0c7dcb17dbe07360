package org.sitaf.agent.toolchain.python.environment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.toolchain.CompilationException;

/** Environments share the files of their packages, and no package can change those of another. */
@Tag("slow")
class UnpackedWheelsTest extends PackagesTest {
  private static final String ARM = "sitaf_unpacked_arm";
  private static final String EVIL = "sitaf_unpacked_evil";

  @BeforeEach
  void addArm() throws Exception {
    index.add(
        "sitaf-unpacked-arm",
        ARM + "-1.0-py3-none-any.whl",
        LocalIndex.wheel(ARM, "OF = 'the arm'\n"));
  }

  private Path make(Path... wheels) throws Exception {
    return make(List.of("sitaf-unpacked-arm"), List.of(wheels), null);
  }

  private Path wheel(String name, String file, Map<String, String> further) throws Exception {
    Map<String, String> files = new TreeMap<>(LocalIndex.files(name, "1.0", ""));
    files.putAll(further);
    return Files.write(directory.resolve(file), LocalIndex.zip(files));
  }

  private String problem(Path wheel) {
    var thrown = new StringBuilder();
    assertThatThrownBy(() -> make(wheel))
        .isInstanceOfSatisfying(
            CompilationException.class, e -> thrown.append(e.diagnostics().get(0).message()));
    return thrown.toString();
  }

  @Test
  void aPackageCannotChangeWhatOtherEnvironmentsHaveOfAnother() throws Exception {
    Path evil =
        wheel(
            EVIL,
            EVIL + "-1.0-py3-none-any.whl",
            Map.of(
                ARM + ".py",
                "OF = 'the attacker'\n",
                "sitaf_runtime/__init__.py",
                "OF = 'the attacker'\n",
                EVIL + "-1.0.data/data/lib/planted",
                ""));

    Path attacked = sitePackages(make(evil));
    Path other = sitePackages(make());

    assertThat(other).isNotEqualTo(attacked);
    assertThat(other.resolve(ARM + ".py")).hasContent("OF = 'the arm'");
    assertThat(attacked.resolve("sitaf_runtime/__init__.py"))
        .hasSameBinaryContentAs(other.resolve("sitaf_runtime/__init__.py"));
    Path common = Path.of("google/protobuf/__init__.py");
    assertThat(Files.isSameFile(attacked.resolve(common), other.resolve(common))).isTrue();
    assertThat(Files.getOwner(other.resolve(common)))
        .isEqualTo(Files.getOwner(directory.resolve("cache")));
    assertThat(other.resolve("pip/__init__.py")).isRegularFile();
    assertThat(other.resolve("__pycache__"))
        .isDirectoryContaining(file -> file.getFileName().toString().startsWith(ARM));
  }

  @Test
  void aWheelThatCannotBeInstalledIsAnErrorOfTheComponent() throws Exception {
    assertThat(problem(wheel(EVIL, EVIL + "-1.0-py2-none-win32.whl", Map.of())))
        .contains(EVIL + "-1.0-py2-none-win32.whl is not a supported wheel on this platform");
    String metadata = "Metadata-Version: 2.1\nName: " + EVIL + "\nVersion: 1.0\n";
    assertThat(
            problem(
                wheel(
                    EVIL,
                    EVIL + "-1.0-py3-none-any.whl",
                    Map.of(
                        EVIL + "-1.0.dist-info/METADATA", metadata + "Requires-Python: >=3.99\n"))))
        .contains("requires a different Python", "not in '>=3.99'");
    assertThat(
            problem(wheel(EVIL, EVIL + "-1.0-py3-none-any.whl", Map.of(ARM + ".py/module.py", ""))))
        .contains("two of the packages contain", ARM + ".py", "one as a file and one as a folder");
    assertThat(
            problem(wheel(EVIL, EVIL + "-1.0-py3-none-any.whl", Map.of("../../../escaped.py", ""))))
        .contains(EVIL);
    assertThat(directory.resolve("cache")).isDirectoryNotContaining("glob:**/escaped.py");
  }
}
