package org.sitaf.agent.toolchain.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.java.confined.Wire;

/** A compromised compiler process may send any answer. */
class CompilerAnswerTest {
  @TempDir private Path directory;
  private final ByteArrayOutputStream answer = new ByteArrayOutputStream();

  private void read(long mostBytes) throws IOException, CompilationException {
    Path output = Files.createDirectories(directory.resolve("output"));
    new CompilerAnswer(List.of(), "demo.Component", output)
        .read(new Wire.Reader(new ByteArrayInputStream(answer.toByteArray()), mostBytes));
  }

  private void answer(String text) {
    answer.writeBytes(text.getBytes(StandardCharsets.UTF_8));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "../Outside.class",
        "/tmp/Outside.class",
        "demo/../../Outside.class",
        "demo//Outside.class",
        "demo/Outside.class\0",
        "demo/./Outside.class",
        "demo/Outside.sh",
        ".class",
        ""
      })
  void aPathThatNoClassHasIsRefused(String path) throws Exception {
    Wire.write(answer, Wire.CLASS, path, "content");

    assertThatThrownBy(() -> read(1000)).isInstanceOf(IOException.class);
    assertThat(directory.resolve("Outside.class")).doesNotExist();
    assertThat(directory.resolve("output")).isEmptyDirectory();
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"class -1\n", "class 9999999999\n", "CLASS 1 1\nab", "done\n", "x", "1\n"})
  void whatIsNoMessageIsRefused(String text) {
    answer(text);

    assertThatThrownBy(() -> read(1000)).isInstanceOf(IOException.class);
  }

  @Test
  void ignoresAnIncompleteLine() {
    answer("c".repeat(1000));

    assertThatThrownBy(() -> read(2000)).hasMessage("not a message");
  }

  @Test
  void doesNotReadMoreThanTheLimit() {
    answer("class 4 2000\nname");

    assertThatThrownBy(() -> read(1000)).hasMessage("more bytes than allowed");
  }

  @Test
  void rejectsTooManyErrors() throws Exception {
    for (int i = 0; i < 101; i++) {
      Wire.write(answer, Wire.ERROR, "-1", "1", "1", "wrong");
    }

    assertThatThrownBy(() -> read(1 << 20)).hasMessageContaining("too many errors");
  }

  @Test
  void rejectsAnErrorInAnUnknownSource() throws Exception {
    Wire.write(answer, Wire.ERROR, "7", "1", "1", "wrong");

    assertThatThrownBy(() -> read(1000)).hasMessageContaining("unknown source");
  }
}
