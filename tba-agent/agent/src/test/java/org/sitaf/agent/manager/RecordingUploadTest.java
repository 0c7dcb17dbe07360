package org.sitaf.agent.manager;

import static org.assertj.core.api.Assertions.assertThat;

import io.grpc.ManagedChannel;
import io.grpc.Status;
import io.grpc.netty.shaded.io.grpc.netty.NettyChannelBuilder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.build.SignalExcerpt;
import org.sitaf.agent.spool.AgentDirectory;
import org.sitaf.agent.spool.Spool;
import org.sitaf.agent.v1.CaseSignals;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.core.trajectory.ConditionSpan;

/** Upload of recordings from the agent's disk to the server. */
@Timeout(300)
class RecordingUploadTest {
  private static final Attempt ATTEMPT = Attempt.of(FakeServer.attempt("b-1", 1, 17));

  @TempDir private Path directory;
  private FakeServer server;
  private ManagedChannel channel;
  private ServerCalls calls;

  @BeforeEach
  void start() throws Exception {
    server = FakeServer.start();
    server.door().disableAuthentication();
    channel = NettyChannelBuilder.forTarget(server.address()).usePlaintext().build();
    calls = new ServerCalls(channel);
  }

  @AfterEach
  void stop() {
    channel.shutdownNow();
    server.close();
  }

  private Path recording(int no) throws Exception {
    return Files.writeString(
        Files.createDirectories(directory.resolve("recordings")).resolve(no + ".glb"), "g" + no);
  }

  @Test
  void uploadsSignalsDuringTheBuild() throws Exception {
    SignalExcerpt excerpt =
        new SignalExcerpt(
            7,
            new long[] {-5, 20},
            List.of(new SignalExcerpt.Signal("robot_x", "m", new double[] {1, 2})),
            List.of(new ConditionSpan("stops", 0, 20, List.of("robot_x"))));
    Path file = SignalFiles.write(directory.resolve("recordings"), 4, excerpt);
    Path recording = recording(4);
    try (RecordingUpload upload = new RecordingUpload(ATTEMPT, calls)) {
      upload.add(file);
      upload.add(recording);
    }

    CaseSignals uploaded = server.signals().get(4);
    assertThat(uploaded.getSamples()).isEqualTo(7);
    assertThat(uploaded.getTimesNsList()).containsExactly(-5L, 20L);
    assertThat(uploaded.getSignals(0).getName()).isEqualTo("robot_x");
    assertThat(uploaded.getSignals(0).getUnit()).isEqualTo("m");
    assertThat(uploaded.getSignals(0).getValuesList()).containsExactly(1.0, 2.0);
    assertThat(uploaded.getConditions(0).getName()).isEqualTo("stops");
    assertThat(uploaded.getConditions(0).getToNs()).isEqualTo(20);
    assertThat(server.recordings()).containsKey(4);
    assertThat(file).doesNotExist();
  }

  @Test
  void uploadsRecordingsDuringTheBuild() throws Exception {
    Path first = recording(1);
    try (RecordingUpload upload = new RecordingUpload(ATTEMPT, calls)) {
      upload.add(first);
      server.await(s -> s.recordings().containsKey(1));
      upload.add(recording(22));
    }

    assertThat(server.recordings()).containsEntry(1, "g1").containsEntry(22, "g22");
    assertThat(directory.resolve("recordings")).isEmptyDirectory();
  }

  @Test
  void leavesRecordingsForTheSpoolDuringAnOutage() throws Exception {
    server.refuseAttempt(Status.UNAVAILABLE);
    Path first = recording(1);
    Path second = recording(2);
    try (RecordingUpload upload = new RecordingUpload(ATTEMPT, calls)) {
      upload.add(first);
      upload.add(second);
    }

    assertThat(first).exists();
    assertThat(second).exists();
  }

  @Test
  void doesNotRetryARejectedRecording() throws Exception {
    server.refuseAttempt(Status.INVALID_ARGUMENT);
    Path first = recording(1);
    try (RecordingUpload upload = new RecordingUpload(ATTEMPT, calls)) {
      upload.add(first);
      // The agent stops within two seconds, which may be too short for a connection on a busy
      // machine.
      for (long end = System.nanoTime() + 30_000_000_000L;
          Files.exists(first) && System.nanoTime() < end; ) {
        Thread.sleep(10);
      }
    }

    assertThat(first).doesNotExist();
  }

  @Test
  void uploadsRecordingsFromTheSpoolBeforeTheResult() throws Exception {
    recording(3);
    try (AgentDirectory agent = AgentDirectory.open(directory.resolve("agent"))) {
      Spool spool = agent.spool();
      try (ResultUpload upload = new ResultUpload(spool, calls)) {
        server.refuseAttempt(Status.UNAVAILABLE);
        upload.add(
            ATTEMPT,
            SubmitResultRequest.newBuilder().setAttempt(ATTEMPT.ref()).build(),
            null,
            directory.resolve("recordings"),
            () -> {});
        Files.delete(directory.resolve("recordings/3.glb"));
        assertThat(spool.entries().get(0).attachments()).hasSize(1);
        server.takeAttempts();
        upload.wake();
        server.await(s -> !s.submitted().isEmpty());
      }
      assertThat(server.recordings()).containsEntry(3, "g3");
      assertThat(server.order()).containsSubsequence("recording 3", "result");
      assertThat(spool.entries()).isEmpty();
    }
  }
}
