package org.sitaf.agent.build;

import static java.util.stream.Collectors.toMap;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.RecordingOrder.Cases;
import org.sitaf.agent.executor.OutputSink;
import org.sitaf.agent.spool.SystemTool;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.Verdict;

@Timeout(300)
class RecordingsTest {
  @TempDir Path folder;
  private final List<Integer> recorded = Collections.synchronizedList(new ArrayList<>());
  private final List<String> remarks = Collections.synchronizedList(new ArrayList<>());

  private Recordings recordings(Cases cases, int most, long bytes) throws IOException {
    Files.createDirectories(folder.resolve("from"));
    return recordings(
        IntStream.rangeClosed(1, 2000)
            .boxed()
            .collect(toMap(no -> no, no -> folder.resolve("from"))),
        cases,
        most,
        bytes);
  }

  private Recordings recordings(Map<Integer, Path> from, Cases cases, int most, long bytes) {
    return new Recordings(
        from,
        folder.resolve("taken"),
        List.of(folder.resolve("relation-1")),
        new RecordingOrder(folder.resolve("to"), cases, most, bytes),
        new BuildListener() {
          @Override
          public void stage(BuildStage stage) {}

          @Override
          public void log(byte[] utf8) {}

          @Override
          public void caseFinished(CaseResult result) {}

          @Override
          public void recorded(int no, Path recording) {
            recorded.add(no);
          }
        },
        new OutputSink() {
          @Override
          public void output(String text, int caseNo) {}

          @Override
          public void remark(String line) {
            remarks.add(line);
          }
        });
  }

  private static byte[] glb(int size) {
    return ByteBuffer.allocate(size)
        .order(ByteOrder.LITTLE_ENDIAN)
        .putInt(0x46546C67)
        .putInt(2)
        .putInt(size)
        .array();
  }

  private static CaseResult result(int no, Verdict verdict) {
    return new CaseResult(no, verdict, List.of(), List.of(), List.of(), null, "");
  }

  private Path from(String name) {
    return folder.resolve("from").resolve(name);
  }

  private List<String> kept() throws IOException {
    try (var files = Files.list(folder.resolve("to"))) {
      return files.map(file -> file.getFileName().toString()).sorted().toList();
    }
  }

  @Test
  void keepsRecordingsAndIgnoresOtherFiles() throws IOException {
    Path secret = Files.write(folder.resolve("secret"), glb(20));
    try (Recordings recordings = recordings(Cases.ALL, 10, 1000)) {
      for (int no = 1; no <= 5; no++) {
        recordings.expect(result(no, Verdict.PASS));
      }
      Files.write(from("1.glb"), glb(16));
      Files.write(from("2.glb"), glb(24));
      Files.writeString(from("virus.exe"), "v");
      Files.createSymbolicLink(from("3.glb"), secret);
      Files.createDirectory(from("4.glb"));
      Files.writeString(from("5.glb"), "no glTF at all");
      Files.write(from("6.glb"), glb(16));
    }

    assertThat(kept()).containsExactly("1.glb", "2.glb");
    assertThat(recorded).containsExactlyInAnyOrder(1, 2);
    assertThat(from("1.glb")).doesNotExist();
    assertThat(remarks).hasSize(2);
    assertThat(remarks.get(0)).startsWith("recordings: 2 cases, 0.0 MiB");
    assertThat(remarks.get(1)).contains("some recordings are lost", "is not a regular file");
  }

  @Test
  void secondRunsAreKeptWithTheirCases() throws IOException {
    Path second = Files.createDirectories(folder.resolve("relation-1"));
    for (int no = 1; no <= 3; no++) {
      Files.write(second.resolve(no + ".glb"), glb(24));
    }
    try (Recordings recordings = recordings(Cases.FAILED, 10, 60)) {
      recordings.expect(result(1, Verdict.PASS));
      recordings.expect(result(2, Verdict.FAIL));
      recordings.expect(result(3, Verdict.FAIL));
      for (int no = 1; no <= 3; no++) {
        Files.write(from(no + ".glb"), glb(16));
      }
    }

    // Case 3 is beyond the limit of 60 bytes: both runs of a case are kept, or none.
    assertThat(kept()).containsExactly("2.glb", "2.relation-1.glb");
    assertThat(RecordingFile.of("2.relation-1.glb")).isEqualTo(new RecordingFile(2, 1));
    assertThat(remarks.get(0)).startsWith("recordings: 1 cases").contains("1 more are omitted");
  }

  @Test
  void takesEachCaseFromTheFolderOfTheProcessThatRunsIt() throws IOException {
    Path one = Files.createDirectories(folder.resolve("part-1"));
    Path two = Files.createDirectories(folder.resolve("part-2"));
    try (Recordings recordings = recordings(Map.of(1, one, 2, two), Cases.ALL, 10, 1000)) {
      recordings.expect(result(1, Verdict.PASS));
      recordings.expect(result(2, Verdict.PASS));
      Files.write(one.resolve("1.glb"), glb(16));
      Files.write(one.resolve("2.glb"), glb(16));
      Files.write(two.resolve("2.glb"), glb(24));
    }

    assertThat(kept()).containsExactly("1.glb", "2.glb");
    assertThat(folder.resolve("to/2.glb")).hasSize(24);
  }

  @Test
  void aPipeInsteadOfARecordingDoesNotBlock() throws Exception {
    try (Recordings recordings = recordings(Cases.ALL, 10, 1000)) {
      SystemTool.run(List.of("mkfifo", from("1.glb").toString()), Duration.ofSeconds(5));
      Files.createSymbolicLink(from("2.glb"), Path.of("/dev/zero"));
      Files.write(from("3.glb"), glb(16));
      for (int no = 1; no <= 3; no++) {
        recordings.expect(result(no, Verdict.PASS));
      }
    }

    assertThat(kept()).containsExactly("3.glb");
    assertThat(remarks.get(1)).contains("some recordings are lost");
  }

  @Test
  void aFileReplacedByAPipeDoesNotBlock() throws Exception {
    Path pipe = folder.resolve("pipe");
    SystemTool.run(List.of("mkfifo", pipe.toString()), Duration.ofSeconds(5));
    Process swapping;
    try (Recordings recordings = recordings(Cases.ALL, 10_000, 1 << 20)) {
      // Replaces a regular file by a pipe and back, thousands of times per second.
      swapping =
          new ProcessBuilder(
                  "python3",
                  "-c",
                  """
                  import os, sys
                  where, pipe = sys.argv[1:]
                  while os.getppid() != 1:
                      for no in range(1, 50):
                          name = f"{where}/{no}.glb"
                          try:
                              open(name + "x", "wb").write(b"no glTF")
                              os.replace(name + "x", name)
                              os.link(pipe, name + "x")
                              os.replace(name + "x", name)
                          except OSError:
                              pass
                  """,
                  from("").toString(),
                  pipe.toString())
              .start();
      try {
        for (int round = 0; round < 10; round++) {
          for (int no = 1; no < 50; no++) {
            recordings.expect(result(no, Verdict.PASS));
          }
          Thread.sleep(210);
        }
      } finally {
        swapping.destroyForcibly().waitFor();
      }
    }

    assertThat(recorded).isEmpty();
  }

  @Test
  void keepsOnlyRecordingsOfFailedCases() throws IOException {
    try (Recordings recordings = recordings(Cases.FAILED, 10, 1000)) {
      List<Verdict> verdicts = List.of(Verdict.PASS, Verdict.FAIL, Verdict.ERROR, Verdict.DONT);
      for (int i = 0; i < verdicts.size(); i++) {
        Files.write(from(i + 1 + ".glb"), glb(16));
        recordings.expect(result(i + 1, verdicts.get(i)));
      }
    }

    assertThat(kept()).containsExactly("2.glb", "3.glb");
    try (var left = Files.list(folder.resolve("from"))) {
      assertThat(left).isEmpty();
    }
  }

  @Test
  void collectsRecordingsWhileTheCasesRun() throws Exception {
    try (Recordings recordings = recordings(Cases.ALL, 10, 1000)) {
      recordings.expect(result(1, Verdict.PASS));
      Path file = Files.write(from("1.glb"), java.util.Arrays.copyOf(glb(100), 50));
      Thread.sleep(500);
      assertThat(recorded).as("half of it").isEmpty();
      Files.write(file, glb(100));
      for (int i = 0; i < 500 && recorded.isEmpty(); i++) {
        Thread.sleep(10);
      }
      assertThat(recorded).containsExactly(1);
    }
  }

  @Test
  void logsOmittedRecordings() throws IOException {
    try (Recordings recordings = recordings(Cases.ALL, 2, 2 << 20)) {
      for (int no = 1; no <= 4; no++) {
        Files.write(from(no + ".glb"), glb(no == 1 ? 3 << 20 : 16));
        recordings.expect(result(no, Verdict.PASS));
      }
    }

    assertThat(kept()).containsExactly("2.glb", "3.glb");
    assertThat(remarks)
        .containsExactly(
            "recordings: 2 cases, 0.0 MiB; 2 more are omitted: a build keeps 2 of at most 2 MiB");
  }

  @Test
  void logsNothingWithoutRecordings() throws IOException {
    try (Recordings recordings = recordings(Cases.ALL, 10, 1000)) {
      recordings.expect(result(1, Verdict.PASS));
    }

    assertThat(folder.resolve("to")).doesNotExist();
    assertThat(remarks).isEmpty();
  }
}
