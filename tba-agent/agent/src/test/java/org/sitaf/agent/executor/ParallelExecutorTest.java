package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.core.suite.TestSuite;

class ParallelExecutorTest {
  private static final Path RECORDING = Path.of("/build/recording");

  private static Map<Integer, Path> folders(int sessions) {
    TestSuite suite = EchoActivity.withBody("return value;").cases(40).application().suite();
    return new ParallelExecutor(TestApplicationExecutor.DEFAULT, sessions)
        .recordingFolders(suite, RECORDING);
  }

  @Test
  void casesOfOneProcessAreRecordedInTheFolderOfTheRequest() {
    assertThat(folders(1).values()).hasSize(40).containsOnly(RECORDING);
  }

  @Test
  void eachProcessHasItsOwnFolderOfRecordings() {
    Set<Path> distinct = new HashSet<>(folders(3).values());

    assertThat(folders(3)).hasSize(40);
    assertThat(distinct)
        .containsExactlyInAnyOrder(
            RECORDING.resolve("part-1"), RECORDING.resolve("part-2"), RECORDING.resolve("part-3"));
  }
}
