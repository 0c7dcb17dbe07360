package org.sitaf.agent.manager;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import com.google.protobuf.ByteString;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class LogFileTest {
  @TempDir private Path directory;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3})
  void chunksTogetherAreTheLogAndEachIsWholeCharacters(int shift) throws IOException {
    String text = "x".repeat(shift) + "aé€😀".repeat(20_000);
    Path log = Files.writeString(directory.resolve("log"), text);

    StringBuilder together = new StringBuilder();
    long offset = 0;
    ByteString chunk = LogFile.chunk(log, offset);
    while (!chunk.isEmpty()) {
      assertThat(chunk.size()).isLessThanOrEqualTo(64 * 1024);
      assertThat(chunk.isValidUtf8()).isTrue();
      together.append(chunk.toString(UTF_8));
      offset += chunk.size();
      chunk = LogFile.chunk(log, offset);
    }
    assertThat(together).hasToString(text);
  }

  @ParameterizedTest
  @ValueSource(strings = {"nothing", "."})
  void whereThereIsNoFileThereIsNothing(String name) throws IOException {
    assertThat(LogFile.chunk(directory.resolve(name), 0)).isEmpty();
  }
}
