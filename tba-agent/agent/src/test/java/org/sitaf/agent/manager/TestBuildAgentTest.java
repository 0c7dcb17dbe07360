package org.sitaf.agent.manager;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import io.grpc.Status;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.testing.EchoActivity;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.BuildFailure.Category;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.core.verdict.TestResult;
import org.sitaf.core.verdict.document.TestResultXml;

/** The complete agent with a fake server. */
@Tag("slow")
@Timeout(300)
class TestBuildAgentTest {
  private static final AttemptRef ATTEMPT = FakeServer.attempt("b-1", 1, 17);
  private static final EchoActivity GOOD =
      EchoActivity.withBody("System.out.println(\"echo \" + value); return value;");
  private static final EchoActivity SLEEPING =
      EchoActivity.withBody("if (value == 2) Thread.sleep(60000); return value;")
          .caseWallSeconds(90);

  /** A field, because a logger without a reference can be collected with its handlers. */
  private static final Logger AGENT_LOG = Logger.getLogger("org.sitaf.agent");

  @TempDir private Path directory;
  private FakeServer server;
  private TestBuildAgent agent;

  private void startBoth() throws IOException {
    server = FakeServer.start();
    startAgent();
  }

  private void startAgent() throws IOException {
    AgentSettings settings =
        new AgentSettings(
            server.address(),
            ServerAccess.byToken(FakeAuthentication.ENROLMENT),
            "tester",
            "1",
            directory,
            1,
            List.of(),
            null,
            SandboxMode.AUTO,
            true,
            Set.of(),
            Map.of("ir1", "unix:/run/ir1.sock"),
            0,
            Duration.ofHours(1));
    agent = new TestBuildAgent(settings, EchoActivity.toolchains(), version -> {});
  }

  @AfterEach
  void stop() {
    if (agent != null) {
      agent.close();
    }
    if (server != null) {
      server.close();
    }
  }

  private void assign(EchoActivity activity) throws InterruptedException {
    server.await(s -> !s.registrations().isEmpty());
    server.assign(ATTEMPT, activity.application().files());
  }

  private List<Path> spooled() throws IOException {
    try (Stream<Path> entries = Files.list(directory.resolve("spool"))) {
      return entries.toList();
    }
  }

  private SubmitResultRequest theResult() throws InterruptedException {
    server.await(s -> !s.submitted().isEmpty());
    assertThat(server.submitted()).hasSize(1);
    return server.submitted().get(0);
  }

  private void awaitEmptySpool() throws Exception {
    for (int i = 0; i < 500 && !spooled().isEmpty(); i++) {
      Thread.sleep(10);
    }
    assertThat(spooled()).isEmpty();
  }

  @Test
  void registersWithItsNameSlotsAndToolchains() throws Exception {
    startBoth();

    server.await(s -> !s.registrations().isEmpty());
    var registration = server.registrations().get(0);
    assertThat(registration.getName()).isEqualTo("tester");
    assertThat(registration.getSlots()).isEqualTo(1);
    assertThat(registration.getToolchains(0).getLanguage()).isEqualTo("java");
    assertThat(registration.getToolchains(0).getVersion()).startsWith("javac 17");
  }

  @Test
  void buildsAnAssignmentAndSubmitsTheResult() throws Exception {
    startBoth();
    assign(GOOD);

    SubmitResultRequest submitted = theResult();
    assertThat(submitted.getAttempt()).isEqualTo(ATTEMPT);
    byte[] document = submitted.getResultDescriptor().toByteArray();
    assertThat(submitted.getSha256()).isEqualTo(Sha256.sha256(document));
    TestResult result = TestResultXml.read(new ByteArrayInputStream(document), "result");
    assertThat(result.summary().pass()).isEqualTo(5);
    assertThat(result.provenance().agent()).isEqualTo("tester 1");
    assertThat(server.states())
        .isSorted()
        .endsWith(AttemptState.ATTEMPT_STATE_RUNNING, AttemptState.ATTEMPT_STATE_UPLOADING);
    assertThat(server.log("b-1")).contains("echo 1\n", "echo 5\n");
    assertThat(server.cases()).extracting(CaseOutcome::getNo).containsExactly(1, 2, 3, 4, 5);
    awaitEmptySpool();
  }

  @Test
  void downloadsAFileOnce() throws Exception {
    startBoth();
    assign(GOOD);
    server.await(s -> s.submitted().size() == 1);
    int downloads = server.downloads();

    server.assign(FakeServer.attempt("b-2", 1, 18), GOOD.application().files());
    server.await(s -> s.submitted().size() == 2);
    assertThat(server.downloads()).isEqualTo(downloads);
  }

  @Test
  void heartbeatsListTheRunningBuild() throws Exception {
    startBoth();
    assign(SLEEPING);
    server.await(s -> !s.cases().isEmpty());
    int before = server.heartbeats().size();

    server.await(s -> s.heartbeats().size() >= before + 5);
    assertThat(server.heartbeats().get(before + 4).getRunningList()).containsExactly(ATTEMPT);
  }

  @Test
  void aCompilerErrorIsAFailureWithDiagnostics() throws Exception {
    startBoth();
    assign(EchoActivity.withBody("return valve;"));

    var failure = theResult().getFailure();
    assertThat(failure.getCategory()).isEqualTo(Category.COMPILATION);
    assertThat(failure.getDiagnostics(0).getFile())
        .isEqualTo("activity/component/demo/Component.java");
    assertThat(failure.getDiagnostics(0).getLine()).isEqualTo(5);
    assertThat(failure.getDiagnostics(0).getMessage()).contains("cannot find symbol", "valve");
    assertThat(server.log("b-1")).contains("Component.java:5:");
  }

  @Test
  void reportsAnInvalidApplication() throws Exception {
    startBoth();
    server.await(s -> !s.registrations().isEmpty());
    server.assign(
        ATTEMPT, GOOD.application().files().with("suite.xml", "<!DOCTYPE x><x/>".getBytes(UTF_8)));

    assertThat(theResult().getFailure().getCategory()).isEqualTo(Category.COMPILATION);
  }

  @Test
  void aCancellationEndsARunningBuild() throws Exception {
    startBoth();
    assign(SLEEPING);
    server.await(s -> !s.cases().isEmpty());
    server.cancel(ATTEMPT, "not wanted");

    var failure = theResult().getFailure();
    assertThat(failure.getCategory()).isEqualTo(Category.CANCELLED);
    assertThat(failure.getMessage()).isEqualTo("not wanted");
  }

  @Test
  void answersTheCancellationOfAnUnknownBuild() throws Exception {
    startBoth();
    server.await(s -> !s.registrations().isEmpty());
    server.cancel(ATTEMPT, "not wanted");

    assertThat(theResult().getFailure().getCategory()).isEqualTo(Category.CANCELLED);
  }

  @Test
  void answersTheCancellationOfAnUnknownBuildIfTheSpoolIsNotWritable() throws Exception {
    startBoth();
    server.await(s -> !s.registrations().isEmpty());
    Files.delete(directory.resolve("spool"));
    Files.createFile(directory.resolve("spool"));
    server.cancel(FakeServer.attempt("unknown", 3, 4), "not wanted");
    server.cancel(FakeServer.attempt("unknown too", 3, 4), "not wanted");

    server.await(s -> s.submitted().size() == 2);
  }

  @Test
  void submitsTheResultOfAnAbandonedAttemptWhoseCasesHaveEnded() throws Exception {
    startBoth();
    // The process runs longer after its last case than an abandoned attempt waits.
    assign(
        EchoActivity.withBody(
            "if (value == 5) new Thread(() -> { try { Thread.sleep(60000); }"
                + " catch (InterruptedException e) { } }).start(); return value;"));
    server.await(s -> s.cases().size() == 5);
    server.giveUp(ATTEMPT);

    TestResult result =
        TestResultXml.read(theResult().getResultDescriptor().newInput(), "late result");
    assertThat(result.summary().pass()).isEqualTo(5);
  }

  @Test
  void stopsAnAbandonedAttemptWithoutAResult() throws Exception {
    startBoth();
    assign(SLEEPING);
    server.await(s -> !s.cases().isEmpty());
    int before = server.heartbeats().size();
    server.giveUp(ATTEMPT);

    server.await(
        s ->
            s.heartbeats().size() > before
                && s.heartbeats().get(s.heartbeats().size() - 1).getRunningCount() == 0);
    awaitEmptySpool();
    assertThat(server.submitted()).isEmpty();
  }

  @Test
  void dropsTheResultOfAnAttemptThatHasEnded() throws Exception {
    startBoth();
    assign(SLEEPING);
    server.await(s -> !s.cases().isEmpty());
    server.refuseAttempt(Status.FAILED_PRECONDITION);
    int before = server.heartbeats().size();
    server.cancel(ATTEMPT, "not wanted");

    server.await(
        s ->
            s.heartbeats().size() > before
                && s.heartbeats().get(s.heartbeats().size() - 1).getRunningCount() == 0);
    awaitEmptySpool();
    assertThat(server.submitted()).isEmpty();
  }

  @Test
  void stopsAnAttemptWhoseReportsAreRejected() throws Exception {
    startBoth();
    server.await(s -> !s.registrations().isEmpty());
    server.assign(
        ATTEMPT,
        EchoActivity.withBody("System.out.println(value); Thread.sleep(300); return value;")
            .cases(500)
            .application()
            .files());
    server.await(s -> !s.cases().isEmpty());
    server.refuseAttempt(Status.FAILED_PRECONDITION);
    int before = server.heartbeats().size();

    server.await(
        s ->
            s.heartbeats().size() > before
                && s.heartbeats().get(s.heartbeats().size() - 1).getRunningCount() == 0);
    assertThat(spooled()).isEmpty();
    assertThat(server.submitted()).isEmpty();
  }

  @Test
  void keepsAnUndeliveredResultAcrossRestarts() throws Exception {
    startBoth();
    server.refuseSubmit(Status.UNAVAILABLE);
    assign(GOOD);
    server.await(s -> s.states().contains(AttemptState.ATTEMPT_STATE_UPLOADING));
    assertThat(spooled()).hasSize(1);
    agent.close();
    assertThat(spooled()).hasSize(1);
    startAgent();
    // Until the result is uploaded, the agent reports the attempt as running.
    server.await(s -> s.registrations().size() > 1);
    server.refuseSubmit(null);

    SubmitResultRequest submitted = theResult();
    TestResult result = TestResultXml.read(submitted.getResultDescriptor().newInput(), "result");
    assertThat(result.summary().pass()).isEqualTo(5);
    assertThat(server.registrations().get(1).getRunningList()).containsExactly(ATTEMPT);
    awaitEmptySpool();
  }

  @Test
  void uploadsResultAndLogAfterAServerOutage() throws Exception {
    startBoth();
    assign(EchoActivity.withBody("System.out.println(value); Thread.sleep(300); return value;"));
    server.await(s -> !s.cases().isEmpty());
    String address = server.address();
    server.close();
    for (int i = 0; i < 1000 && spooled().isEmpty(); i++) {
      Thread.sleep(10);
    }
    server = FakeServer.startAt(address);

    SubmitResultRequest submitted = theResult();
    assertThat(submitted.hasResultDescriptor()).isTrue();
    assertThat(server.log("b-1")).contains("1\n2\n3\n4\n5\n");
    server.await(s -> !s.registrations().isEmpty());
  }

  @Test
  void stopsABuildWithRealDevicesWhenItsLeaseIsLost() throws Exception {
    startBoth();
    server.await(s -> !s.registrations().isEmpty());
    server.assign(ATTEMPT, SLEEPING.application().files(), "ir1");
    server.await(s -> !s.cases().isEmpty());
    CountDownLatch stopped = new CountDownLatch(1);
    Handler log = onLogged("its lease was lost", stopped);
    AGENT_LOG.addHandler(log);
    try {
      String address = server.address();
      server.close();
      assertThat(stopped.await(60, TimeUnit.SECONDS)).isTrue();
      server = FakeServer.startAt(address);
    } finally {
      AGENT_LOG.removeHandler(log);
    }

    server.await(
        s ->
            !s.heartbeats().isEmpty()
                && s.heartbeats().get(s.heartbeats().size() - 1).getRunningCount() == 0);
    var failure = theResult().getFailure();
    assertThat(failure.getCategory()).isEqualTo(Category.INFRASTRUCTURE);
  }

  private static Handler onLogged(String words, CountDownLatch latch) {
    return new Handler() {
      @Override
      public void publish(LogRecord entry) {
        if (entry.getMessage().contains(words)) {
          latch.countDown();
        }
      }

      @Override
      public void flush() {}

      @Override
      public void close() {}
    };
  }

  @Test
  void offersTheDevicesOfItsSettings() throws Exception {
    startBoth();
    server.await(s -> !s.registrations().isEmpty());
    assertThat(server.registrations().get(0).getDevicesList()).containsExactly("ir1");
  }

  @Test
  void reconnectsAfterTheEndOfTheStream() throws Exception {
    startBoth();
    server.await(s -> s.registrations().size() == 1);
    server.endStream();

    server.await(s -> s.registrations().size() == 2);
  }

  @Test
  void deletesASupersededResult() throws Exception {
    startBoth();
    server.rejectCalls();
    assign(GOOD);

    theResult();
    awaitEmptySpool();
  }

  @Test
  void setsARejectedResultAsideAndEndsTheBuild() throws Exception {
    startBoth();
    server.refuseSubmit(Status.INVALID_ARGUMENT.withDescription("not a descriptor"));
    assign(GOOD);

    var failure = theResult().getFailure();
    assertThat(failure.getCategory()).isEqualTo(Category.INFRASTRUCTURE);
    assertThat(failure.getMessage()).contains("not a descriptor");
    assertThat(spooled()).anyMatch(path -> path.getFileName().toString().startsWith("rejected."));
  }

  @Test
  void doesNotBuildDamagedFiles() throws Exception {
    startBoth();
    server.damageDownloads(true);
    assign(GOOD);

    var failure = theResult().getFailure();
    assertThat(failure.getCategory()).isEqualTo(Category.INFRASTRUCTURE);
    assertThat(failure.getMessage()).contains("has the digest");
  }

  @Test
  void returnsBuildsIfAllSlotsAreTaken() throws Exception {
    startBoth();
    assign(SLEEPING);
    server.await(s -> !s.cases().isEmpty());
    server.assign(FakeServer.attempt("b-2", 1, 18), GOOD.application().files());

    SubmitResultRequest submitted = theResult();
    assertThat(submitted.getAttempt().getBuildId()).isEqualTo("b-2");
    assertThat(submitted.getFailure().getMessage()).contains("no free slot");
  }

  @Test
  void aStoppedAgentReportsItsBuilds() throws Exception {
    startBoth();
    assign(SLEEPING);
    server.await(s -> !s.cases().isEmpty());
    agent.close();

    var failure = theResult().getFailure();
    assertThat(failure.getCategory()).isEqualTo(Category.INFRASTRUCTURE);
    assertThat(failure.getMessage()).isEqualTo("the agent was stopped");
  }

  @Test
  void twoAgentsDoNotShareAFolder() throws Exception {
    startBoth();

    assertThatThrownBy(this::startAgent)
        .isInstanceOf(IOException.class)
        .hasMessageContaining("is used by another agent");
  }
}
