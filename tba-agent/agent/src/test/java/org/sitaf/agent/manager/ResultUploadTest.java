package org.sitaf.agent.manager;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.protobuf.ByteString;
import io.grpc.ManagedChannel;
import io.grpc.Status;
import io.grpc.netty.shaded.io.grpc.netty.NettyChannelBuilder;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.spool.AgentDirectory;
import org.sitaf.agent.v1.SubmitResultRequest;

/** Damaged entries of the spool do not delay other entries and do not renew leases. */
@Timeout(300)
class ResultUploadTest {
  private static final Attempt BROKEN = Attempt.of(FakeServer.attempt("b-1", 1, 17));
  private static final Attempt GOOD = Attempt.of(FakeServer.attempt("b-2", 1, 18));

  @TempDir private Path directory;
  private FakeServer server;
  private ManagedChannel channel;
  private ServerCalls calls;
  private AgentDirectory agent;

  @BeforeEach
  void start() throws Exception {
    server = FakeServer.start();
    server.door().disableAuthentication();
    channel = NettyChannelBuilder.forTarget(server.address()).usePlaintext().build();
    calls = new ServerCalls(channel);
    agent = AgentDirectory.open(directory.resolve("agent"));
  }

  @AfterEach
  void stop() throws Exception {
    agent.close();
    channel.shutdownNow();
    server.close();
  }

  private static SubmitResultRequest failureOf(Attempt attempt) {
    return SubmitMessages.infrastructure(attempt, "for the test");
  }

  private Path unreadableRecordings() throws IOException {
    Path recordings = Files.createDirectories(directory.resolve("recordings"));
    Files.writeString(recordings.resolve("not-a-number.glb"), "g");
    return recordings;
  }

  private Path entry(Attempt attempt) {
    return directory.resolve("agent/spool").resolve(attempt.key());
  }

  private static void awaitNothingPending(ResultUpload upload) throws InterruptedException {
    while (!upload.pending().isEmpty()) {
      upload.wake();
      Thread.sleep(5);
    }
  }

  @Test
  void anEntryThatFailsWithARuntimeExceptionDoesNotDelayOthers() throws Exception {
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      upload.add(BROKEN, failureOf(BROKEN), null, unreadableRecordings(), () -> {});
      upload.add(GOOD, failureOf(GOOD), null, null, () -> {});

      server.await(s -> s.submitted().stream().anyMatch(m -> m.getAttempt().equals(GOOD.ref())));
    }
  }

  @Test
  void setsAnUnreadableEntryAsideAndEndsItsLease() throws Exception {
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      upload.add(BROKEN, failureOf(BROKEN), null, unreadableRecordings(), () -> {});
      upload.add(GOOD, failureOf(GOOD), null, null, () -> {});

      awaitNothingPending(upload);
    }
    assertThat(server.submitted()).extracting(m -> m.getAttempt()).containsExactly(GOOD.ref());
    assertThat(directory.resolve("agent/spool/rejected." + BROKEN.key())).isDirectory();
  }

  @Test
  void reportsAStoredResultBeforeTheServerCanLearnOfIt() throws Exception {
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      List<Integer> submitted = new ArrayList<>();
      upload.add(
          GOOD,
          failureOf(GOOD),
          null,
          null,
          () -> {
            assertThat(upload.isPending(GOOD)).isTrue();
            upload.wake();
            // Time for the upload, which must not begin.
            LockSupport.parkNanos(Duration.ofMillis(300).toNanos());
            submitted.add(server.submitted().size());
          });
      awaitNothingPending(upload);

      assertThat(submitted).containsExactly(0);
    }
    assertThat(server.submitted()).hasSize(1);
  }

  @Test
  void endsTheLeaseOfAnAttemptWithoutAnEntry() throws Exception {
    server.refuseAttempt(Status.UNAVAILABLE);
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      upload.add(BROKEN, failureOf(BROKEN), null, null, () -> {});
      assertThat(upload.isPending(BROKEN)).isTrue();
      Files.move(entry(BROKEN), directory.resolve("elsewhere"));

      awaitNothingPending(upload);
    }
  }

  @Test
  void setsADamagedEntryAsideAtTheStart() throws Exception {
    agent.spool().put(BROKEN.key(), new byte[] {-1, -1}, null, null);
    agent.spool().put(GOOD.key(), failureOf(GOOD).toByteArray(), null, null);
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      assertThat(upload.isPending(BROKEN)).isFalse();
      server.await(s -> !s.submitted().isEmpty());
      awaitNothingPending(upload);
    }
    assertThat(directory.resolve("agent/spool/rejected." + BROKEN.key())).isDirectory();
  }

  @Test
  void retriesToSendARefusalOfAnAssignment() throws Exception {
    server.refuseAttempt(Status.UNAVAILABLE);
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      upload.refuse(GOOD, failureOf(GOOD));
      assertThat(upload.isPending(GOOD)).isTrue();
      server.takeAttempts();
      awaitNothingPending(upload);
    }
    assertThat(server.submitted()).hasSize(1);
  }

  @Test
  void doesNotRetryAResultThatIsTooLargeForAnOldServer() throws Exception {
    server.disableParts();
    try (ResultUpload upload = new ResultUpload(agent.spool(), calls)) {
      SubmitResultRequest large =
          SubmitResultRequest.newBuilder()
              .setAttempt(GOOD.ref())
              .setResultDescriptor(ByteString.copyFrom(new byte[9 << 20]))
              .build();
      upload.add(GOOD, large, null, null, () -> {});
      awaitNothingPending(upload);
    }
    assertThat(server.submitted())
        .singleElement()
        .satisfies(m -> assertThat(m.getFailure().getMessage()).contains("9 MiB", "update it"));
  }
}
