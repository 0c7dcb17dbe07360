package org.sitaf.agent.toolchain.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.spool.SystemTool;
import org.sitaf.core.verdict.Coverage;
import org.sitaf.core.verdict.Coverage.Line;

/** Reads reports of the real tools. */
class ReportsTest {
  @TempDir private Path directory;

  @Test
  void mergesCoverageOfTwoProcesses() throws Exception {
    assumeTrue(Files.isExecutable(Path.of("/usr/bin/g++")), "skipped: g++ is not installed");
    assumeTrue(Files.isExecutable(Path.of("/usr/bin/gcov")), "skipped: gcov is not installed");
    Path sources = Files.createDirectories(directory.resolve("activity/component"));
    Files.writeString(
        sources.resolve("sign.cpp"),
        """
        int sign(int x) {
          if (x > 0) {
            return 1;
          }
          if (x == 0) {
            return 0;
          }
          return -1;
        }
        int main(int count, char**) { return sign(count - 2) > 1; }
        """);
    Path notes = Files.createDirectories(directory.resolve("notes"));
    run(
        directory,
        Map.of(),
        "g++",
        "--coverage",
        "-ffile-prefix-map=" + directory + "/=",
        "-c",
        sources.resolve("sign.cpp").toString(),
        "-o",
        notes.resolve("unit0.o").toString());
    run(
        directory,
        Map.of(),
        "g++",
        "--coverage",
        notes.resolve("unit0.o").toString(),
        "-o",
        directory.resolve("sign").toString());
    Path data = Files.createDirectories(directory.resolve("data"));
    run(directory, Map.of("GCOV_PREFIX", data.resolve("one").toString()), "./sign");
    run(directory, Map.of("GCOV_PREFIX", data.resolve("two").toString()), "./sign", "a", "b");

    Coverage coverage =
        GcovReport.read(
            data,
            notes,
            directory.resolve("scratch"),
            SandboxMode.AUTO.open(),
            "activity/",
            "component/");

    assertThat(coverage.files()).hasSize(1);
    assertThat(coverage.files().get(0).path()).isEqualTo("component/sign.cpp");
    assertThat(coverage.files().get(0).lines())
        .contains(
            new Line(2, true, 2, 2),
            new Line(3, true, 0, 0),
            new Line(5, true, 2, 1),
            new Line(6, false, 0, 0),
            new Line(8, true, 0, 0));
  }

  @Test
  void readsAReportOfCoveragePy() {
    Coverage coverage =
        LcovReport.read(
            """
            TN:
            SF:/a/activity/component/sign.py
            DA:1,1,abc
            DA:2,1,abc
            DA:3,0,abc
            LF:3
            BRDA:2,0,0,1
            BRDA:2,0,1,-
            end_of_record
            SF:/a/activity/adapter/other.py
            DA:1,1
            end_of_record
            SF:/usr/lib/python3/json.py
            DA:1,1
            end_of_record
            """,
            "/a/activity",
            "component/");

    assertThat(coverage.files())
        .containsExactly(
            new Coverage.File(
                "component/sign.py",
                List.of(
                    new Line(1, true, 0, 0), new Line(2, true, 2, 1), new Line(3, false, 0, 0))));
    assertThat(coverage.branch()).hasValue(50);
  }

  private static void run(Path folder, Map<String, String> environment, String... command)
      throws Exception {
    ProcessBuilder builder = new ProcessBuilder(command).directory(folder.toFile()).inheritIO();
    builder.environment().putAll(environment);
    assertThat(builder.start().waitFor()).isZero();
  }

  @Test
  void gcovIsGivenNothingButFiles(@TempDir Path folder) throws Exception {
    Path data = Files.createDirectories(folder.resolve("data/process1"));
    Path notes = Files.createDirectory(folder.resolve("notes"));
    for (String unit : List.of("pipe", "link", "folder", "nonsense")) {
      Files.writeString(notes.resolve(unit + ".gcno"), "x");
    }
    SystemTool.run(List.of("mkfifo", data.resolve("pipe.gcda").toString()), Duration.ofSeconds(5));
    Files.createSymbolicLink(data.resolve("link.gcda"), notes.resolve("link.gcno"));
    Files.createDirectory(data.resolve("folder.gcda"));

    Coverage coverage =
        GcovReport.read(
            folder.resolve("data"), notes, folder.resolve("scratch"), Sandbox.none(), "a/", "s/");
    assertThat(coverage.files()).isEmpty();
    assertThat(folder.resolve("scratch")).doesNotExist();

    Files.write(data.resolve("nonsense.gcda"), new byte[33 << 20]);
    assertThatThrownBy(
            () ->
                GcovReport.read(
                    folder.resolve("data"),
                    notes,
                    folder.resolve("scratch"),
                    Sandbox.none(),
                    "a/",
                    "s/"))
        .hasMessageContaining("nonsense.gcda has more than");
  }
}
