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
import org.sitaf.agent.v1.AppendLogRequest;
import org.sitaf.agent.v1.Assignment;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.CaseOutcome;
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
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.Provenance;
import org.sitaf.core.verdict.ResultAssembler;
import org.sitaf.core.verdict.Verdict;
import org.sitaf.core.verdict.document.TestResultXml;
import org.sitaf.server.file.StoredFiles;

/**
 * An agent at the rim: speaks the protocol over a real connection, one call at a time, as a test
 * says.
 */
public final class RimAgent implements AutoCloseable {
  private static final int PATIENCE_S = 30;
  private static final Metadata.Key<String> AUTHORIZATION =
      Metadata.Key.of("authorization", Metadata.ASCII_STRING_MARSHALLER);

  /** By port of the server and name of the agent, as if in files of theirs. */
  private static final Map<String, String> KEYS = new ConcurrentHashMap<>();

  private final ManagedChannel channel;
  private final AgentServiceGrpc.AgentServiceBlockingStub calls;
  private final int port;
  private @Nullable StreamObserver<AgentMessage> stream;
  private volatile @Nullable String key;
  private final BlockingQueue<ServerMessage> received = new LinkedBlockingQueue<>();
  private final CompletableFuture<Throwable> end = new CompletableFuture<>();

  private RimAgent(int port) {
    this.port = port;
    channel = ManagedChannelBuilder.forAddress("localhost", port).usePlaintext().build();
    calls = AgentServiceGrpc.newBlockingStub(ClientInterceptors.intercept(channel, new ShownKey()));
  }

  /** Shows the agent's key, once it has one. */
  private final class ShownKey implements ClientInterceptor {
    @Override
    public <Q, A> ClientCall<Q, A> interceptCall(
        MethodDescriptor<Q, A> method, CallOptions options, Channel next) {
      return new SimpleForwardingClientCall<>(next.newCall(method, options)) {
        @Override
        public void start(Listener<A> listener, Metadata headers) {
          String present = key;
          if (present != null) {
            headers.put(AUTHORIZATION, "Bearer " + present);
          }
          super.start(listener, headers);
        }
      };
    }
  }

  /** Gets the agent a key, or uses the one that an agent of its name and server got before. */
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

  /** Gets the agent a key for an enrolment of the server's. */
  public void enrolWith(String token, String name) {
    key = calls.enrol(EnrolRequest.newBuilder().setToken(token).setName(name).build()).getKey();
  }

  /** Shows this key from now on. */
  public void useKey(String other) {
    key = other;
  }

  private synchronized StreamObserver<AgentMessage> stream() {
    StreamObserver<AgentMessage> present = stream;
    if (present == null) {
      present = connect();
      stream = present;
    }
    return present;
  }

  private StreamObserver<AgentMessage> connect() {
    return AgentServiceGrpc.newStub(ClientInterceptors.intercept(channel, new ShownKey()))
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

  /** Connects and sends nothing. */
  public static RimAgent dial(int port) {
    return new RimAgent(port);
  }

  /** Connects, registers with one slot, and waits for the server's answer. */
  public static RimAgent register(int port, String name, String language, AttemptRef... running) {
    return register(port, name, 1, List.of(), language, running);
  }

  /** Connects, registers, and waits for the server's answer. */
  public static RimAgent register(
      int port,
      String name,
      int slots,
      List<String> labels,
      String language,
      AttemptRef... running) {
    RimAgent agent = dial(port);
    agent.sendRegister(name, slots, labels, language, running);
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

  /** With the key that the agent has, whosever it is. */
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
                        .addAllLabels(labels)
                        .addToolchains(
                            Toolchain.newBuilder().setLanguage(language).setVersion("test"))
                        .addAllRunning(List.of(running)))
                .build());
  }

  /** A heartbeat that says why no new build is taken. */
  public void refuse(String why) {
    stream()
        .onNext(
            AgentMessage.newBuilder().setHeartbeat(Heartbeat.newBuilder().setRefuses(why)).build());
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
      ServerMessage message = received.poll(PATIENCE_S, TimeUnit.SECONDS);
      if (message == null) {
        throw new AssertionError("nothing came from the server");
      }
      return message;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IllegalStateException(e);
    }
  }

  /** Whether the server sends nothing for a while. */
  public boolean hearsNothingFor(long ms) throws InterruptedException {
    return received.poll(ms, TimeUnit.MILLISECONDS) == null;
  }

  public Assignment nextAssignment() {
    ServerMessage message = next();
    if (!message.hasAssignment()) {
      throw new AssertionError("not an assignment: " + message);
    }
    return message.getAssignment();
  }

  /** Why the stream ended, once it has. */
  public Throwable end() throws Exception {
    return end.get(PATIENCE_S, TimeUnit.SECONDS);
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

  /** Tells all of cases that have ended. */
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
        .forEachRemaining(part -> content.writeBytes(part.getChunk().toByteArray()));
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

  /** Hands a result in by parts; whether it was accepted. */
  public boolean submitInParts(AttemptRef attempt, byte[] document, int part) throws Exception {
    CompletableFuture<Boolean> accepted = new CompletableFuture<>();
    StreamObserver<SubmitResultRequest> parts =
        AgentServiceGrpc.newStub(ClientInterceptors.intercept(channel, new ShownKey()))
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
                    // The answer has been looked at.
                  }
                });
    for (int at = 0; at < document.length; at += part) {
      parts.onNext(
          SubmitResultRequest.newBuilder()
              .setAttempt(attempt)
              .setSha256(StoredFiles.sha256(document))
              .setResultDescriptor(
                  ByteString.copyFrom(document, at, Math.min(part, document.length - at)))
              .build());
    }
    parts.onCompleted();
    return accepted.get(PATIENCE_S, TimeUnit.SECONDS);
  }

  public boolean submit(AttemptRef attempt, BuildFailure failure) {
    return calls
        .submitResult(
            SubmitResultRequest.newBuilder().setAttempt(attempt).setFailure(failure).build())
        .getAccepted();
  }

  /** A result of the application in which each case passes, but for the numbers that fail. */
  public static byte[] result(TestApplication application, List<Integer> failing) {
    return result(application, failing, List.of());
  }

  /** As {@link #result}, with reasons not to trust it. */
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
            "aa", 1, "bb", "cc", "rim test", "", "2026-01-01T00:00:00Z", "2026-01-01T00:00:01Z");
    TestResultXml.write(
        new ResultAssembler(application.model(), application.suite())
            .assemble(results, "not executed", provenance)
            .suspected(suspicions),
        document);
    return document.toByteArray();
  }

  /** Goes away without a word. */
  @Override
  public void close() {
    channel.shutdownNow();
    try {
      channel.awaitTermination(PATIENCE_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
