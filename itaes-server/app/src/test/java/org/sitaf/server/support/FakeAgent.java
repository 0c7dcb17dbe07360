package org.sitaf.server.support;

import com.google.protobuf.ByteString;
import io.grpc.CallOptions;
import io.grpc.Channel;
import io.grpc.ClientCall;
import io.grpc.ClientInterceptor;
import io.grpc.ClientInterceptors;
import io.grpc.ForwardingClientCall.SimpleForwardingClientCall;
import io.grpc.ManagedChannel;
import io.grpc.ManagedChannelBuilder;
import io.grpc.Metadata;
import io.grpc.MethodDescriptor;
import io.grpc.StatusRuntimeException;
import io.grpc.stub.StreamObserver;
import java.io.ByteArrayOutputStream;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AnalysisReport;
import org.sitaf.agent.v1.AppendLogRequest;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.CaseSignals;
import org.sitaf.agent.v1.DownloadFileRequest;
import org.sitaf.agent.v1.EnrolRequest;
import org.sitaf.agent.v1.Heartbeat;
import org.sitaf.agent.v1.Register;
import org.sitaf.agent.v1.ReportCasesRequest;
import org.sitaf.agent.v1.ReportStateRequest;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;
import org.sitaf.agent.v1.Toolchain;
import org.sitaf.agent.v1.UploadRecordingRequest;
import org.sitaf.agent.v1.UploadSignalsRequest;
import org.sitaf.agent.v1.UploadSignalsResponse;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.file.StoredFiles;

/** A fake agent, with which tests make single calls of the protocol over a real connection. */
public final class FakeAgent implements AutoCloseable {
  private static final int TIMEOUT_S = 120;
  private static final Metadata.Key<String> AUTHORIZATION =
      Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER);

  /** Keys of enrolled agents by port of the server and name of the agent. */
  private static final Map<String, String> KEYS = new ConcurrentHashMap<>();

  private final ManagedChannel channel;
  private final AgentServiceGrpc.AgentServiceBlockingStub calls;
  private final int port;
  private @Nullable StreamObserver<AgentMessage> stream;
  private volatile @Nullable String key;
  private List<String> devices = List.of();
  private final BlockingQueue<ServerMessage> received = new LinkedBlockingQueue<>();
  private final CompletableFuture<Throwable> end = new CompletableFuture<>();

  private FakeAgent(int port) {
    this.port = port;
    channel = ManagedChannelBuilder.forAddress("localhost", port).usePlaintext().build();
    calls =
        AgentServiceGrpc.newBlockingStub(
            ClientInterceptors.intercept(channel, new KeyInterceptor()));
  }

  /** Adds the agent's key to each call. */
  private final class KeyInterceptor implements ClientInterceptor {
    @Override
    public <Q, A> ClientCall<Q, A> interceptCall(
        MethodDescriptor<Q, A> method, CallOptions options, Channel next) {
      return new SimpleForwardingClientCall<>(next.newCall(method, options)) {
        @Override
        public void start(Listener<A> listener, Metadata headers) {
          String current = key;
          if (current != null) {
            headers.put(AUTHORIZATION, "Bearer " + current);
          }
          super.start(listener, headers);
        }
      };
    }
  }

  /** Enrols the agent, or uses the key of an earlier agent of the same name. */
  public void enrol(String name) {
    key =
        KEYS.computeIfAbsent(
            port + " " + name,
            unknown ->
                calls
                    .enrol(
                        EnrolRequest.newBuilder()
                            .setToken(ServerTest.ENROLMENT)
                            .setName(name)
                            .build())
                    .getKey());
  }

  /** Enrols the agent with a token. */
  public void enrolWith(String token, String name) {
    key = calls.enrol(EnrolRequest.newBuilder().setToken(token).setName(name).build()).getKey();
  }

  public void useKey(String newKey) {
    key = newKey;
  }

  private synchronized StreamObserver<AgentMessage> stream() {
    StreamObserver<AgentMessage> current = stream;
    if (current == null) {
      current = connect();
      stream = current;
    }
    return current;
  }

  private StreamObserver<AgentMessage> connect() {
    return AgentServiceGrpc.newStub(ClientInterceptors.intercept(channel, new KeyInterceptor()))
        .connect(
            new StreamObserver<>() {
              @Override
              public void onNext(ServerMessage message) {
                received.add(message);
              }

              @Override
              public void onError(Throwable error) {
                end.complete(error);
              }

              @Override
              public void onCompleted() {
                end.complete(new IllegalStateException("regular end"));
              }
            });
  }

  /** Connects without sending a message. */
  public static FakeAgent dial(int port) {
    return new FakeAgent(port);
  }

  /** Connects, registers with one slot, and waits for the response. */
  public static FakeAgent register(int port, String name, String language, AttemptRef... running) {
    return register(port, name, 1, List.of(), language, running);
  }

  /** Connects, registers, and waits for the response. */
  public static FakeAgent register(
      int port,
      String name,
      int slots,
      List<String> labels,
      String language,
      AttemptRef... running) {
    FakeAgent agent = dial(port);
    agent.sendRegister(name, slots, labels, language, running);
    if (!agent.next().hasRegistered()) {
      throw new AssertionError("not registered");
    }
    return agent;
  }

  /** Connects with real devices, registers, and waits for the response. */
  public static FakeAgent offering(
      int port, String name, int slots, List<String> devices, AttemptRef... running) {
    FakeAgent agent = dial(port);
    agent.devices = List.copyOf(devices);
    agent.sendRegister(name, slots, List.of(), "java", running);
    if (!agent.next().hasRegistered()) {
      throw new AssertionError("not registered");
    }
    return agent;
  }

  public void sendRegister(String name, String language, AttemptRef... running) {
    sendRegister(name, 1, List.of(), language, running);
  }

  public void sendRegister(
      String name, int slots, List<String> labels, String language, AttemptRef... running) {
    try {
      enrol(name);
    } catch (StatusRuntimeException e) {
      end.complete(e);
      return;
    }
    sendRegisterUnenrolled(name, slots, labels, language, running);
  }

  /** Registers with the current key, without enrolling. */
  public void sendRegisterUnenrolled(
      String name, int slots, List<String> labels, String language, AttemptRef... running) {
    stream()
        .onNext(
            AgentMessage.newBuilder()
                .setRegister(
                    Register.newBuilder()
                        .setName(name)
                        .setVersion("test")
                        .setSlots(slots)
                        .setSimulation(true)
                        .setAnalyses(true)
                        .addAllLabels(labels)
                        .addAllDevices(devices)
                        .addToolchains(
                            Toolchain.newBuilder().setLanguage(language).setVersion("test"))
                        .addAllRunning(List.of(running)))
                .build());
  }

  /** Sends a heartbeat with the reason why the agent accepts no builds. */
  public void heartbeatRefusing(String reason) {
    stream()
        .onNext(
            AgentMessage.newBuilder()
                .setHeartbeat(Heartbeat.newBuilder().setRefuses(reason))
                .build());
  }

  public void heartbeat(AttemptRef... running) {
    stream()
        .onNext(
            AgentMessage.newBuilder()
                .setHeartbeat(Heartbeat.newBuilder().addAllRunning(List.of(running)))
                .build());
  }

  public ServerMessage next() {
    try {
      for (int second = 0; second < TIMEOUT_S; second++) {
        ServerMessage message = received.poll(1, TimeUnit.SECONDS);
        if (message != null) {
          return message;
        }
        if (end.isDone()) {
          throw new AssertionError("the server closed the stream", end.getNow(null));
        }
      }
      throw new AssertionError("no message from the server");
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** Whether the server sends no message for the given time. */
  public boolean receivesNothingFor(long ms) throws InterruptedException {
    return received.poll(ms, TimeUnit.MILLISECONDS) == null;
  }

  public Assignment nextAssignment() {
    ServerMessage message = next();
    if (!message.hasAssignment()) {
      throw new AssertionError("not an assignment: " + message);
    }
    return message.getAssignment();
  }

  /** Waits for the end of the stream and returns the error. */
  public Throwable end() throws Exception {
    return end.get(TIMEOUT_S, TimeUnit.SECONDS);
  }

  public void report(AttemptRef attempt, AttemptState state) {
    calls.reportState(ReportStateRequest.newBuilder().setAttempt(attempt).setState(state).build());
  }

  public void reportCases(AttemptRef attempt, int... numbers) {
    List<CaseOutcome> outcomes = new ArrayList<>();
    for (int no : numbers) {
      outcomes.add(CaseOutcome.newBuilder().setNo(no).setVerdict("PASS").build());
    }
    calls.reportCases(
        ReportCasesRequest.newBuilder().setAttempt(attempt).addAllOutcomes(outcomes).build());
  }

  /** Reports finished cases with all their values. */
  public void reportOutcomes(AttemptRef attempt, CaseOutcome... outcomes) {
    calls.reportCases(
        ReportCasesRequest.newBuilder()
            .setAttempt(attempt)
            .addAllOutcomes(List.of(outcomes))
            .build());
  }

  public long appendLog(AttemptRef attempt, long offset, String text) {
    return calls
        .appendLog(
            AppendLogRequest.newBuilder()
                .setAttempt(attempt)
                .setOffset(offset)
                .setChunk(ByteString.copyFromUtf8(text))
                .build())
        .getNextOffset();
  }

  public byte[] download(AttemptRef attempt, String sha256) {
    ByteArrayOutputStream content = new ByteArrayOutputStream();
    calls
        .downloadFile(
            DownloadFileRequest.newBuilder().setAttempt(attempt).setSha256(sha256).build())
        .forEachRemaining(response -> content.writeBytes(response.getChunk().toByteArray()));
    return content.toByteArray();
  }

  public TestApplication download(Assignment assignment) {
    Map<String, byte[]> files = new HashMap<>();
    assignment
        .getFilesList()
        .forEach(f -> files.put(f.getPath(), download(assignment.getAttempt(), f.getSha256())));
    return TestApplication.read(FileTree.of(files));
  }

  public void uploadRecording(AttemptRef attempt, int caseNo, byte[] gltf) {
    uploadRecording(attempt, caseNo, gltf, StoredFiles.sha256(gltf));
  }

  public void uploadRecording(AttemptRef attempt, int caseNo, byte[] gltf, String sha256) {
    calls.uploadRecording(
        UploadRecordingRequest.newBuilder()
            .setAttempt(attempt)
            .setCaseNo(caseNo)
            .setGltf(ByteString.copyFrom(gltf))
            .setSha256(sha256)
            .build());
  }

  /**
   * Uploads the recording of a second run.
   *
   * @param relation from 1
   */
  public void uploadRecording(AttemptRef attempt, int caseNo, int relation, byte[] gltf) {
    calls.uploadRecording(
        UploadRecordingRequest.newBuilder()
            .setAttempt(attempt)
            .setCaseNo(caseNo)
            .setRelation(relation)
            .setGltf(ByteString.copyFrom(gltf))
            .setSha256(StoredFiles.sha256(gltf))
            .build());
  }

  public void uploadSignals(AttemptRef attempt, int caseNo, CaseSignals signals) {
    UploadSignalsResponse unused =
        calls.uploadSignals(
            UploadSignalsRequest.newBuilder()
                .setAttempt(attempt)
                .setCaseNo(caseNo)
                .setSignals(signals)
                .build());
  }

  public boolean submit(AttemptRef attempt, byte[] document) {
    return submit(attempt, document, StoredFiles.sha256(document));
  }

  public boolean submit(AttemptRef attempt, byte[] document, String sha256) {
    return calls
        .submitResult(
            SubmitResultRequest.newBuilder()
                .setAttempt(attempt)
                .setResultDescriptor(ByteString.copyFrom(document))
                .setSha256(sha256)
                .build())
        .getAccepted();
  }

  /** Submits a result in chunks; returns whether it was accepted. */
  public boolean submitInChunks(AttemptRef attempt, byte[] document, int chunkSize)
      throws Exception {
    CompletableFuture<Boolean> accepted = new CompletableFuture<>();
    StreamObserver<SubmitResultRequest> chunks =
        AgentServiceGrpc.newStub(ClientInterceptors.intercept(channel, new KeyInterceptor()))
            .submitResultInParts(
                new StreamObserver<>() {
                  @Override
                  public void onNext(SubmitResultResponse answer) {
                    accepted.complete(answer.getAccepted());
                  }

                  @Override
                  public void onError(Throwable failure) {
                    accepted.completeExceptionally(failure);
                  }

                  @Override
                  public void onCompleted() {
                    // onNext completed the future.
                  }
                });
    for (int at = 0; at < document.length; at += chunkSize) {
      chunks.onNext(
          SubmitResultRequest.newBuilder()
              .setAttempt(attempt)
              .setSha256(StoredFiles.sha256(document))
              .setResultDescriptor(
                  ByteString.copyFrom(document, at, Math.min(chunkSize, document.length - at)))
              .build());
    }
    chunks.onCompleted();
    return accepted.get(TIMEOUT_S, TimeUnit.SECONDS);
  }

  /** Submits the report of an analysis. */
  public boolean submit(AttemptRef attempt, AnalysisReport report) {
    return calls
        .submitResult(
            SubmitResultRequest.newBuilder()
                .setAttempt(attempt)
                .setAnalysis(report)
                .setSha256(StoredFiles.sha256(report.toByteArray()))
                .build())
        .getAccepted();
  }

  public boolean submit(AttemptRef attempt, BuildFailure failure) {
    return calls
        .submitResult(
            SubmitResultRequest.newBuilder().setAttempt(attempt).setFailure(failure).build())
        .getAccepted();
  }

  /** A result in which all cases pass, except those with the given numbers. */
  public static byte[] result(TestApplication application, List<Integer> failing) {
    return result(application, failing, List.of());
  }

  /** A result as above, with suspicions. */
  public static byte[] result(
      TestApplication application, List<Integer> failing, List<String> suspicions) {
    List<CaseResult> results =
        application.suite().cases().stream()
            .map(
                c -> {
                  boolean fails = failing.contains(c.no());
                  List<NamedValue> expected =
                      c.expected().stream()
                          .map(e -> new NamedValue(e.output(), e.literal()))
                          .toList();
                  return new CaseResult(
                      c.no(),
                      fails ? Verdict.FAIL : Verdict.PASS,
                      c.values(),
                      expected,
                      fails ? List.of(new NamedValue("", "42.0")) : expected,
                      new CaseResult.ProcessingTime(c.no(), 0.5, 0),
                      fails ? "a wrong value" : "");
                })
            .toList();
    ByteArrayOutputStream document = new ByteArrayOutputStream();
    Provenance provenance =
        new Provenance(
            "aa", 1, "bb", "cc", "fake agent", "", "2026-01-01T00:00:00Z", "2026-01-01T00:00:01Z");
    TestResultXml.write(
        new ResultAssembler(application.model(), application.suite())
            .assemble(results, "not executed", provenance)
            .withSuspicions(suspicions),
        document);
    return document.toByteArray();
  }

  /** Closes the connection without ending the stream. */
  @Override
  public void close() {
    channel.shutdownNow();
    try {
      channel.awaitTermination(TIMEOUT_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
