package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import com.google.protobuf.Duration;
import io.grpc.Server;
import io.grpc.ServerInterceptors;
import io.grpc.Status;
import io.grpc.netty.shaded.io.grpc.netty.NettyServerBuilder;
import io.grpc.stub.StreamObserver;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AppendLogRequest;
import org.sitaf.agent.v1.AppendLogResponse;
import org.sitaf.agent.v1.ApplicationFile;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.Cancellation;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.CaseSignals;
import org.sitaf.agent.v1.DownloadFileRequest;
import org.sitaf.agent.v1.DownloadFileResponse;
import org.sitaf.agent.v1.EnrolRequest;
import org.sitaf.agent.v1.EnrolResponse;
import org.sitaf.agent.v1.Heartbeat;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.Registered;
import org.sitaf.agent.v1.ReportCasesRequest;
import org.sitaf.agent.v1.ReportCasesResponse;
import org.sitaf.agent.v1.ReportStateRequest;
import org.sitaf.agent.v1.ReportStateResponse;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;
import org.sitaf.agent.v1.UploadRecordingRequest;
import org.sitaf.agent.v1.UploadRecordingResponse;
import org.sitaf.agent.v1.UploadSignalsRequest;
import org.sitaf.agent.v1.UploadSignalsResponse;
import org.sitaf.core.activity.FileTree;

/**
 * A fake server on a free port of the loopback interface: implements the protocol, records calls,
 * and fails on request.
 */
final class FakeServer extends AgentServiceGrpc.AgentServiceImplBase implements AutoCloseable {
  private static final int LIMIT_OF_OLD_RELEASES = 8 << 20;

  private final Server server;
  private final FakeAuthentication door = new FakeAuthentication();
  private final Map<String, byte[]> files = new HashMap<>();
  private final List<Register> registrations = new ArrayList<>();
  private final List<Heartbeat> heartbeats = new ArrayList<>();
  private final List<AttemptState> states = new ArrayList<>();
  private final List<CaseOutcome> cases = new ArrayList<>();
  private final List<SubmitResultRequest> submitted = new ArrayList<>();
  private final Map<String, ByteArrayOutputStream> logs = new HashMap<>();
  private @Nullable StreamObserver<ServerMessage> agent;
  private final Map<Integer, String> recordings = new HashMap<>();
  private final Map<Integer, CaseSignals> signals = new HashMap<>();
  private final List<String> order = new ArrayList<>();
  private int downloads;
  private boolean damageDownloads;
  private boolean superseded;
  private volatile boolean knowsParts = true;
  private volatile int parts;
  private @Nullable Status refuseSubmit;
  private @Nullable Status refuseAttempt;

  private FakeServer(int port) throws IOException {
    server =
        NettyServerBuilder.forAddress(new InetSocketAddress(InetAddress.getLoopbackAddress(), port))
            .addService(ServerInterceptors.intercept(this, door))
            .maxInboundMessageSize(64 << 20)
            .build()
            .start();
  }

  static FakeServer start() throws IOException {
    return new FakeServer(0);
  }

  /** A new server at the address of a closed one. */
  static FakeServer startAt(String address) throws IOException {
    return new FakeServer(Integer.parseInt(address.substring(address.indexOf(':') + 1)));
  }

  String address() {
    return "127.0.0.1:" + server.getPort();
  }

  @Override
  public void close() {
    server.shutdownNow();
    try {
      server.awaitTermination();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** Authentication. */
  FakeAuthentication door() {
    return door;
  }

  // Commands for tests.

  static AttemptRef attempt(String build, int number, long token) {
    return AttemptRef.newBuilder()
        .setBuildId(build)
        .setAttempt(number)
        .setFencingToken(token)
        .build();
  }

  synchronized void assign(AttemptRef attempt, FileTree application, String... devices) {
    Assignment.Builder assignment =
        Assignment.newBuilder()
            .setAttempt(attempt)
            .setActivity("echo")
            .setModel("Echo")
            .addAllDevices(List.of(devices));
    for (String path : application.paths()) {
      byte[] content = application.content(path).orElseThrow();
      String digest = Sha256.sha256(content);
      files.put(digest, content);
      assignment.addFiles(
          ApplicationFile.newBuilder().setPath(path).setSha256(digest).setSize(content.length));
    }
    send(ServerMessage.newBuilder().setAssignment(assignment).build());
  }

  synchronized void cancel(AttemptRef attempt, String reason) {
    send(Cancellation.newBuilder().setAttempt(attempt).setReason(reason));
  }

  /** Cancels like a server whose lease has expired. */
  synchronized void giveUp(AttemptRef attempt) {
    send(Cancellation.newBuilder().setAttempt(attempt).setReason("lost").setGivenUp(true));
  }

  private void send(Cancellation.Builder cancellation) {
    send(ServerMessage.newBuilder().setCancellation(cancellation).build());
  }

  private void send(ServerMessage message) {
    if (agent == null) {
      throw new IllegalStateException("no agent is connected");
    }
    agent.onNext(message);
  }

  synchronized void damageDownloads(boolean damage) {
    damageDownloads = damage;
  }

  synchronized void rejectCalls() {
    superseded = true;
  }

  synchronized void refuseSubmit(@Nullable Status status) {
    refuseSubmit = status;
  }

  synchronized void takeAttempts() {
    refuseAttempt = null;
  }

  /** Answers every call about an attempt with this status. */
  synchronized void refuseAttempt(Status status) {
    refuseAttempt = status;
  }

  synchronized void endStream() {
    if (agent != null) {
      agent.onCompleted();
    }
  }

  // Queries for tests.

  synchronized void await(Predicate<FakeServer> condition) throws InterruptedException {
    long end = System.nanoTime() + 30_000_000_000L;
    while (!condition.test(this)) {
      long left = (end - System.nanoTime()) / 1_000_000;
      if (left <= 0) {
        throw new AssertionError("nothing of the kind within 30 s");
      }
      wait(left);
    }
  }

  synchronized List<Register> registrations() {
    return List.copyOf(registrations);
  }

  synchronized List<Heartbeat> heartbeats() {
    return List.copyOf(heartbeats);
  }

  synchronized List<AttemptState> states() {
    return List.copyOf(states);
  }

  synchronized List<CaseOutcome> cases() {
    return List.copyOf(cases);
  }

  synchronized List<SubmitResultRequest> submitted() {
    return List.copyOf(submitted);
  }

  /** Uploaded recordings as text, by case. */
  synchronized Map<Integer, String> recordings() {
    return Map.copyOf(recordings);
  }

  /** Uploaded signals, by case. */
  synchronized Map<Integer, CaseSignals> signals() {
    return Map.copyOf(signals);
  }

  /** The order in which recordings and results arrived. */
  synchronized List<String> order() {
    return List.copyOf(order);
  }

  synchronized String log(String build) {
    ByteArrayOutputStream log = logs.get(build);
    return log == null ? "" : log.toString(StandardCharsets.UTF_8);
  }

  synchronized int downloads() {
    return downloads;
  }

  // The protocol.

  @Override
  public void enrol(EnrolRequest request, StreamObserver<EnrolResponse> answers) {
    door.enrol(request, answers);
  }

  @Override
  public StreamObserver<AgentMessage> connect(StreamObserver<ServerMessage> responses) {
    return new StreamObserver<>() {
      @Override
      public void onNext(AgentMessage message) {
        synchronized (FakeServer.this) {
          if (message.hasRegister()) {
            agent = responses;
            registrations.add(message.getRegister());
            Registered registered =
                Registered.newBuilder()
                    .setServerVersion("test")
                    .setLease(Duration.newBuilder().setNanos(400_000_000))
                    .build();
            responses.onNext(ServerMessage.newBuilder().setRegistered(registered).build());
          } else {
            heartbeats.add(message.getHeartbeat());
          }
          FakeServer.this.notifyAll();
        }
      }

      @Override
      public void onError(Throwable failure) {
        forget();
      }

      @Override
      public void onCompleted() {
        forget();
        responses.onCompleted();
      }

      private void forget() {
        synchronized (FakeServer.this) {
          if (agent == responses) {
            agent = null;
          }
        }
      }
    };
  }

  @Override
  public synchronized void downloadFile(
      DownloadFileRequest request, StreamObserver<DownloadFileResponse> responses) {
    if (refused(responses)) {
      return;
    }
    downloads++;
    byte[] content = files.get(request.getSha256());
    if (content == null) {
      responses.onError(Status.NOT_FOUND.asRuntimeException());
      return;
    }
    byte[] sent = content.clone();
    if (damageDownloads) {
      sent[0] ^= 1;
    }
    for (int offset = 0; offset < sent.length; offset += 1000) {
      int length = Math.min(1000, sent.length - offset);
      responses.onNext(
          DownloadFileResponse.newBuilder()
              .setChunk(ByteString.copyFrom(sent, offset, length))
              .build());
    }
    responses.onCompleted();
  }

  @Override
  public synchronized void reportState(
      ReportStateRequest request, StreamObserver<ReportStateResponse> responses) {
    if (!refused(responses)) {
      states.add(request.getState());
      answer(responses, ReportStateResponse.getDefaultInstance());
    }
  }

  @Override
  public synchronized void appendLog(
      AppendLogRequest request, StreamObserver<AppendLogResponse> responses) {
    if (refused(responses)) {
      return;
    }
    ByteArrayOutputStream log =
        logs.computeIfAbsent(
            request.getAttempt().getBuildId(), build -> new ByteArrayOutputStream());
    long offset = request.getOffset();
    if (offset > log.size()) {
      responses.onError(
          Status.OUT_OF_RANGE.withDescription("ends at " + log.size()).asRuntimeException());
      return;
    }
    byte[] chunk = request.getChunk().toByteArray();
    int known = (int) Math.min(chunk.length, log.size() - offset);
    log.write(chunk, known, chunk.length - known);
    answer(responses, AppendLogResponse.newBuilder().setNextOffset(log.size()).build());
  }

  @Override
  public synchronized void reportCases(
      ReportCasesRequest request, StreamObserver<ReportCasesResponse> responses) {
    if (!refused(responses)) {
      cases.addAll(request.getOutcomesList());
      answer(responses, ReportCasesResponse.getDefaultInstance());
    }
  }

  @Override
  public synchronized void uploadRecording(
      UploadRecordingRequest request, StreamObserver<UploadRecordingResponse> responses) {
    if (!refused(responses)) {
      recordings.put(request.getCaseNo(), request.getGltf().toStringUtf8());
      order.add("recording " + request.getCaseNo());
      answer(
          responses, UploadRecordingResponse.newBuilder().setSha256(request.getSha256()).build());
    }
  }

  @Override
  public synchronized void uploadSignals(
      UploadSignalsRequest request, StreamObserver<UploadSignalsResponse> responses) {
    if (!refused(responses)) {
      signals.put(request.getCaseNo(), request.getSignals());
      answer(responses, UploadSignalsResponse.getDefaultInstance());
    }
  }

  @Override
  public synchronized void submitResult(
      SubmitResultRequest request, StreamObserver<SubmitResultResponse> responses) {
    if (refused(responses)) {
      return;
    }
    if (!knowsParts && request.getResultDescriptor().size() > LIMIT_OF_OLD_RELEASES) {
      responses.onError(Status.RESOURCE_EXHAUSTED.asRuntimeException());
      return;
    }
    if (refuseSubmit != null && request.hasResultDescriptor()) {
      responses.onError(refuseSubmit.asRuntimeException());
      return;
    }
    submitted.add(request);
    order.add("result");
    answer(
        responses,
        SubmitResultResponse.newBuilder()
            .setAccepted(!superseded)
            .setSha256(request.getSha256())
            .setSize(request.getResultDescriptor().size())
            .build());
  }

  @Override
  public StreamObserver<SubmitResultRequest> submitResultInParts(
      StreamObserver<SubmitResultResponse> responses) {
    if (!knowsParts) {
      return super.submitResultInParts(responses);
    }
    return new StreamObserver<>() {
      private final SubmitResultRequest.Builder whole = SubmitResultRequest.newBuilder();

      @Override
      public void onNext(SubmitResultRequest part) {
        parts++;
        whole
            .setAttempt(part.getAttempt())
            .setSha256(part.getSha256())
            .setResultDescriptor(whole.getResultDescriptor().concat(part.getResultDescriptor()));
      }

      @Override
      public void onError(Throwable failure) {
        // Nothing is stored.
      }

      @Override
      public void onCompleted() {
        submitResult(whole.build(), responses);
      }
    };
  }

  /** Behaves like a release without support for parts. */
  void disableParts() {
    knowsParts = false;
  }

  /** The number of received parts of results. */
  int parts() {
    return parts;
  }

  private boolean refused(StreamObserver<?> responses) {
    if (refuseAttempt != null) {
      responses.onError(refuseAttempt.asRuntimeException());
      return true;
    }
    return false;
  }

  private <T> void answer(StreamObserver<T> responses, T response) {
    responses.onNext(response);
    responses.onCompleted();
    notifyAll();
  }
}
