package org.sitaf.server.build.agent;

import com.google.protobuf.ByteString;
import io.grpc.stub.ServerCallStreamObserver;
import io.grpc.stub.StreamObserver;
import java.time.Clock;
import java.util.function.Supplier;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AppendLogRequest;
import org.sitaf.agent.v1.AppendLogResponse;
import org.sitaf.agent.v1.BuildFailure;
import org.sitaf.agent.v1.DownloadFileRequest;
import org.sitaf.agent.v1.DownloadFileResponse;
import org.sitaf.agent.v1.EnrolRequest;
import org.sitaf.agent.v1.EnrolResponse;
import org.sitaf.agent.v1.ReportCasesRequest;
import org.sitaf.agent.v1.ReportCasesResponse;
import org.sitaf.agent.v1.ReportStateRequest;
import org.sitaf.agent.v1.ReportStateResponse;
import org.sitaf.agent.v1.ServerMessage;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;
import org.sitaf.agent.v1.UploadRecordingRequest;
import org.sitaf.agent.v1.UploadRecordingResponse;
import org.sitaf.server.access.enrolment.Enrolments;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.Attempts.Delivery;
import org.sitaf.server.build.log.BuildLogs;
import org.sitaf.server.build.recording.Recordings;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.result.Results;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.stereotype.Service;

/** The agents' gRPC service; agent.proto says what each call means. */
@Service
class AgentService extends AgentServiceGrpc.AgentServiceImplBase {
  private static final int CHUNK = 64 << 10;
  private static final int LARGEST_ENROLMENT = 16 << 10;

  private final Enrolments enrolments;
  private final Agents agents;
  private final Dispatcher dispatcher;
  private final Attempts attempts;
  private final BuildLogs logs;
  private final Recordings recordings;
  private final StoredFiles contents;
  private final SitafSettings settings;
  private final DiskSpace disk;
  private final PartsMemory memory;
  private final Clock clock;

  AgentService(
      Enrolments enrolments,
      Agents agents,
      Dispatcher dispatcher,
      Attempts attempts,
      BuildLogs logs,
      Recordings recordings,
      StoredFiles contents,
      SitafSettings settings,
      DiskSpace disk,
      PartsMemory memory,
      Clock clock) {
    this.enrolments = enrolments;
    this.agents = agents;
    this.dispatcher = dispatcher;
    this.attempts = attempts;
    this.logs = logs;
    this.recordings = recordings;
    this.contents = contents;
    this.settings = settings;
    this.disk = disk;
    this.memory = memory;
    this.clock = clock;
  }

  @Override
  public void enrol(EnrolRequest request, StreamObserver<EnrolResponse> answers) {
    answer(
        answers,
        () -> {
          if (request.getSerializedSize() > LARGEST_ENROLMENT) {
            throw Refusal.malformed("token: is longer than any that this server makes.");
          }
          String key =
              enrolments.enrol(
                  request.getToken(), request.getName(), AgentAuthentication.address());
          return EnrolResponse.newBuilder().setKey(key).build();
        });
  }

  @Override
  public StreamObserver<AgentMessage> connect(StreamObserver<ServerMessage> answers) {
    return new AgentStream(agents, dispatcher, settings, clock, answers);
  }

  @Override
  public void downloadFile(
      DownloadFileRequest request, StreamObserver<DownloadFileResponse> answers) {
    byte[] content;
    try {
      AttemptKey key = Messages.toKey(request.getAttempt());
      content = contents.content(attempts.file(key, request.getSha256()).sha256());
    } catch (RuntimeException e) {
      answers.onError(StatusOf.exception(e));
      return;
    }
    sendChunks(content, (ServerCallStreamObserver<DownloadFileResponse>) answers);
  }

  @Override
  public void reportState(ReportStateRequest request, StreamObserver<ReportStateResponse> answers) {
    answer(
        answers,
        () -> {
          attempts.advance(
              Messages.toKey(request.getAttempt()), Messages.toState(request.getState()));
          return ReportStateResponse.getDefaultInstance();
        });
  }

  @Override
  public void appendLog(AppendLogRequest request, StreamObserver<AppendLogResponse> answers) {
    answer(
        answers,
        () -> {
          if (request.getChunk().size() > CHUNK) {
            throw Refusal.malformed("chunk: must be at most 64 KiB.");
          }
          disk.requireFor(request.getChunk().size());
          long end =
              logs.append(
                  Messages.toKey(request.getAttempt()),
                  request.getOffset(),
                  request.getChunk().toByteArray());
          return AppendLogResponse.newBuilder().setNextOffset(end).build();
        });
  }

  @Override
  public void reportCases(ReportCasesRequest request, StreamObserver<ReportCasesResponse> answers) {
    answer(
        answers,
        () -> {
          long next =
              attempts.noteCases(
                  Messages.toKey(request.getAttempt()),
                  request.getSequence(),
                  request.getOutcomesList().stream().map(Messages::toCase).toList());
          return ReportCasesResponse.newBuilder().setNextSequence(next).build();
        });
  }

  @Override
  public void uploadRecording(
      UploadRecordingRequest request, StreamObserver<UploadRecordingResponse> answers) {
    answer(answers, () -> store(request, request.getGltf().toByteArray()));
  }

  @Override
  public StreamObserver<UploadRecordingRequest> uploadRecordingInParts(
      StreamObserver<UploadRecordingResponse> answers) {
    return new InParts<>(
        new InParts.Shape<>(UploadRecordingRequest::getAttempt, UploadRecordingRequest::getGltf),
        this::store,
        memory,
        answers);
  }

  private UploadRecordingResponse store(UploadRecordingRequest request, byte[] gltf) {
    disk.requireFor(gltf.length);
    recordings.store(
        Messages.toKey(request.getAttempt()), request.getCaseNo(), gltf, request.getSha256());
    return UploadRecordingResponse.newBuilder().setSha256(request.getSha256()).build();
  }

  @Override
  public void submitResult(
      SubmitResultRequest request, StreamObserver<SubmitResultResponse> answers) {
    answer(answers, () -> take(request, request.getResultDescriptor().toByteArray()));
  }

  @Override
  public StreamObserver<SubmitResultRequest> submitResultInParts(
      StreamObserver<SubmitResultResponse> answers) {
    return new InParts<>(
        new InParts.Shape<>(
            SubmitResultRequest::getAttempt, SubmitResultRequest::getResultDescriptor),
        this::take,
        memory,
        answers);
  }

  private SubmitResultResponse take(SubmitResultRequest request, byte[] descriptor) {
    AttemptKey key = Messages.toKey(request.getAttempt());
    disk.requireFor(descriptor.length);
    boolean accepted =
        switch (request.getOutcomeCase()) {
          case RESULT_DESCRIPTOR -> deliver(key, descriptor, request.getSha256());
          case FAILURE -> fail(key, request.getFailure());
          case OUTCOME_NOT_SET ->
              throw Refusal.malformed("outcome: must be a result_descriptor or a failure.");
        };
    return SubmitResultResponse.newBuilder()
        .setAccepted(accepted)
        .setSha256(request.getSha256())
        .setSize(descriptor.length)
        .setLogSize(logs.size(key))
        .build();
  }

  private boolean deliver(AttemptKey key, byte[] document, String sha256) {
    String actual = StoredFiles.sha256(document);
    if (!actual.equals(sha256)) {
      throw Refusal.malformed("sha256: is " + sha256 + ", the document's is " + actual + ".");
    }
    Delivery delivery = attempts.deliver(key, Results.read(document), document, sha256);
    if (delivery == Delivery.GIVEN_UP) {
      throw io.grpc.Status.FAILED_PRECONDITION
          .withDescription("the attempt was given up")
          .asRuntimeException();
    }
    return delivery == Delivery.ACCEPTED;
  }

  private boolean fail(AttemptKey key, BuildFailure failure) {
    if (failure.getCategory() == BuildFailure.Category.CANCELLED) {
      attempts.cancelled(key, failure.getMessage().isEmpty() ? "cancelled" : failure.getMessage());
    } else {
      attempts.fail(key, Messages.toFailure(failure));
    }
    return true;
  }

  private static <T> void answer(StreamObserver<T> answers, Supplier<T> call) {
    T answer;
    try {
      answer = call.get();
    } catch (RuntimeException e) {
      answers.onError(StatusOf.exception(e));
      return;
    }
    answers.onNext(answer);
    answers.onCompleted();
  }

  /** Sends as fast as the agent takes it, so that many downloads do not pile up in memory. */
  private static void sendChunks(
      byte[] content, ServerCallStreamObserver<DownloadFileResponse> answers) {
    Runnable onReady =
        new Runnable() {
          private int sent;
          private boolean done;

          @Override
          public void run() {
            while (!done && answers.isReady() && sent < content.length) {
              int size = Math.min(CHUNK, content.length - sent);
              answers.onNext(
                  DownloadFileResponse.newBuilder()
                      .setChunk(ByteString.copyFrom(content, sent, size))
                      .build());
              sent += size;
            }
            if (!done && sent == content.length) {
              done = true;
              answers.onCompleted();
            }
          }
        };
    answers.setOnReadyHandler(onReady);
  }
}
