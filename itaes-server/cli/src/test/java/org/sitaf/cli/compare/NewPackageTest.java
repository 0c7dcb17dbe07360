package org.sitaf.cli.compare;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.diagnostic.InvalidInputException;

class NewPackageTest {
  private static Activity activity(String component, String... pathsAndTexts) {
    Map<String, byte[]> files = new HashMap<>();
    files.put(
        "activity.yaml",
        ("name: a\ncomponent: {" + component + "}\nprovided: [a.idl]\n").getBytes(UTF_8));
    files.put("a.idl", "interface A { double Get(); };".getBytes(UTF_8));
    for (int i = 0; i < pathsAndTexts.length; i += 2) {
      files.put(pathsAndTexts[i], pathsAndTexts[i + 1].getBytes(UTF_8));
    }
    return Activity.readWithoutComponent(FileTree.of(files));
  }

  @Test
  void replacesTheReleaseOfTheComponent() {
    Activity python = activity("language: python, package: Simple_PID==1.0.1, class: a.A");
    assertThat(NewPackage.parse("simple-pid==2.0.1").in(python).text("activity.yaml").orElseThrow())
        .contains("package: simple-pid==2.0.1, class: a.A");
    Activity java = activity("language: java, package: 'g.h:arm:1.0', class: a.A");
    assertThat(NewPackage.parse("g.h:arm==1.1").in(java).text("activity.yaml").orElseThrow())
        .contains("package: 'g.h:arm:1.1', class: a.A");
  }

  @Test
  void readsAMavenPackageAsTheProfileNamesIt() {
    assertThat(NewPackage.parse("g.h:arm:1.1")).isEqualTo(NewPackage.parse("g.h:arm==1.1"));
  }

  @Test
  void replacesADependency() {
    FileTree files =
        NewPackage.parse("numpy==2.4.0")
            .in(
                activity(
                    "language: python, sources: component/, class: a.A",
                    "component/requirements.txt",
                    "NumPy>=1.20 # arrays\nnumpy-stl==3.0\n",
                    "component/a.py",
                    ""));
    assertThat(files.text("component/requirements.txt")).contains("numpy-stl==3.0\n");
    assertThat(files.text("requirements.txt")).contains("numpy==2.4.0\n");
  }

  @Test
  void keepsTheOtherPackagesOfALock() {
    String digest = "0123456789abcdef".repeat(4);
    ResolvedPackage six = new ResolvedPackage("six", "1.16.0", digest);
    ResolvedPackage numpy = new ResolvedPackage("numpy", "2.4.6", digest);
    FileTree files =
        NewPackage.parse("NumPy==2.4.0")
            .in(
                activity(
                    "language: python, sources: component/, class: a.A",
                    "component/requirements.txt",
                    "numpy\nsix\n",
                    ActivityLock.FILE,
                    new ActivityLock(List.of(six, numpy), true).text()));
    assertThat(ActivityLock.of(files)).contains(new ActivityLock(List.of(six), false));
  }

  @Test
  void refusesAPackageThatTheComponentCannotUse() {
    Activity java = activity("language: java, sources: component/, class: a.A");
    assertThatThrownBy(() -> NewPackage.parse("numpy==2.4.0").in(java))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("is not the package of the component, which has none");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "numpy",
        "numpy==",
        "numpy:1.0",
        "g:arm",
        "g:arm:jar:1.0",
        "-r x==1",
        "a==1; b",
        "a @ http://x==1",
        "a==1\nb==2"
      })
  void refusesOtherForms(String text) {
    assertThatThrownBy(() -> NewPackage.parse(text))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("must be NAME==VERSION");
  }
}
