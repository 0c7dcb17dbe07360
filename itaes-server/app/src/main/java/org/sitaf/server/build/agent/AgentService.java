package org.sitaf.server.build.agent;

import com.google.protobuf.ByteString;
import io.grpc.stub.ServerCallStreamObserver;
import io.grpc.stub.StreamObserver;
import java.time.Clock;
import java.util.function.Supplier;
import org.sitaf.agent.v1.AgentMessage;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AnalysisReport;
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
import org.sitaf.agent.v1.UploadSignalsRequest;
import org.sitaf.agent.v1.UploadSignalsResponse;
import org.sitaf.server.access.enrolment.Enrolments;
import org.sitaf.server.build.AttemptKey;
import org.sitaf.server.build.Attempts;
import org.sitaf.server.build.Attempts.Delivery;
import org.sitaf.server.build.log.BuildLogs;
import org.sitaf.server.build.recording.Recordings;
import org.sitaf.server.build.signal.StoredSignals;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.file.StoredFiles;
import org.sitaf.server.result.Results;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DiskSpace;
import org.springframework.stereotype.Service;
import tools.jackson.databind.json.JsonMapper;

/** The gRPC service for agents; see agent.proto. */
@Service
class AgentService extends AgentServiceGrpc.AgentServiceImplBase {
  private static final int MAX_CHUNK = 64 << 10;
  private static final int MAX_ENROLMENT = 16 << 10;

  private final Enrolments enrolments;
  private final Agents agents;
  private final Dispatcher dispatcher;
  private final Attempts attempts;
  private final BuildLogs logs;
  private final Recordings recordings;
  private final StoredSignals signals;
  private final JsonMapper json;
  private final SitafSettings settings;
  private final DiskSpace disk;
  private final UploadMemory memory;
  private final Clock clock;

  AgentService(
      Enrolments enrolments,
      Agents agents,
      Dispatcher dispatcher,
      Attempts attempts,
      BuildLogs logs,
      Recordings recordings,
      StoredSignals signals,
      JsonMapper json,
      SitafSettings settings,
      DiskSpace disk,
      UploadMemory memory,
      Clock clock) {
    this.enrolments = enrolments;
    this.agents = agents;
    this.dispatcher = dispatcher;
    this.attempts = attempts;
    this.logs = logs;
    this.recordings = recordings;
    this.signals = signals;
    this.json = json;
    this.settings = settings;
    this.disk = disk;
    this.memory = memory;
    this.clock = clock;
  }

  @Override
  public void enrol(EnrolRequest request, StreamObserver<EnrolResponse> responses) {
    answer(
        responses,
        () -> {
          if (request.getSerializedSize() > MAX_ENROLMENT) {
            throw RequestException.malformed("token: is too long.");
          }
          String key =
              enrolments.enrol(
                  request.getToken(), request.getName(), AgentAuthentication.address());
          return EnrolResponse.newBuilder().setKey(key).build();
        });
  }

  @Override
  public StreamObserver<AgentMessage> connect(StreamObserver<ServerMessage> responses) {
    return new AgentStream(agents, dispatcher, settings, clock, responses);
  }

  @Override
  public void downloadFile(
      DownloadFileRequest request, StreamObserver<DownloadFileResponse> responses) {
    byte[] content;
    try {
      AttemptKey key = Messages.toKey(request.getAttempt());
      content = attempts.content(key, request.getSha256());
    } catch (RuntimeException e) {
      responses.onError(GrpcStatus.exception(e));
      return;
    }
    sendChunks(content, (ServerCallStreamObserver<DownloadFileResponse>) responses);
  }

  @Override
  public void reportState(
      ReportStateRequest request, StreamObserver<ReportStateResponse> responses) {
    answer(
        responses,
        () -> {
          attempts.advance(
              Messages.toKey(request.getAttempt()), Messages.toState(request.getState()));
          return ReportStateResponse.getDefaultInstance();
        });
  }

  @Override
  public void appendLog(AppendLogRequest request, StreamObserver<AppendLogResponse> responses) {
    answer(
        responses,
        () -> {
          if (request.getChunk().size() > MAX_CHUNK) {
            throw RequestException.malformed("chunk: must be at most 64 KiB.");
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
  public void reportCases(
      ReportCasesRequest request, StreamObserver<ReportCasesResponse> responses) {
    answer(
        responses,
        () -> {
          long next =
              attempts.addCases(
                  Messages.toKey(request.getAttempt()),
                  request.getSequence(),
                  request.getOutcomesList().stream().map(Messages::toCase).toList());
          return ReportCasesResponse.newBuilder().setNextSequence(next).build();
        });
  }

  @Override
  public void uploadRecording(
      UploadRecordingRequest request, StreamObserver<UploadRecordingResponse> responses) {
    answer(responses, () -> store(request, request.getGltf().toByteArray()));
  }

  @Override
  public StreamObserver<UploadRecordingRequest> uploadRecordingInParts(
      StreamObserver<UploadRecordingResponse> responses) {
    return new ChunkedUpload<>(
        new ChunkedUpload.Fields<>(
            UploadRecordingRequest::getAttempt, UploadRecordingRequest::getGltf),
        this::store,
        memory,
        responses);
  }

  private UploadRecordingResponse store(UploadRecordingRequest request, byte[] gltf) {
    disk.requireFor(gltf.length);
    recordings.store(
        Messages.toKey(request.getAttempt()),
        request.getCaseNo(),
        request.getRelation(),
        gltf,
        request.getSha256());
    return UploadRecordingResponse.newBuilder().setSha256(request.getSha256()).build();
  }

  @Override
  public void uploadSignals(
      UploadSignalsRequest request, StreamObserver<UploadSignalsResponse> responses) {
    answer(
        responses,
        () -> {
          disk.requireFor(request.getSerializedSize());
          signals.store(
              Messages.toKey(request.getAttempt()),
              request.getCaseNo(),
              Messages.toSignals(request.getSignals()));
          return UploadSignalsResponse.getDefaultInstance();
        });
  }

  @Override
  public void submitResult(
      SubmitResultRequest request, StreamObserver<SubmitResultResponse> responses) {
    answer(responses, () -> submit(request, request.getResultDescriptor().toByteArray()));
  }

  @Override
  public StreamObserver<SubmitResultRequest> submitResultInParts(
      StreamObserver<SubmitResultResponse> responses) {
    return new ChunkedUpload<>(
        new ChunkedUpload.Fields<>(
            SubmitResultRequest::getAttempt, SubmitResultRequest::getResultDescriptor),
        this::submit,
        memory,
        responses);
  }

  private SubmitResultResponse submit(SubmitResultRequest request, byte[] descriptor) {
    AttemptKey key = Messages.toKey(request.getAttempt());
    disk.requireFor(descriptor.length);
    boolean accepted =
        switch (request.getOutcomeCase()) {
          case RESULT_DESCRIPTOR -> deliver(key, descriptor, request.getSha256());
          case FAILURE -> fail(key, request.getFailure());
          case ANALYSIS -> deliver(key, request.getAnalysis(), request.getSha256());
          case OUTCOME_NOT_SET ->
              throw RequestException.malformed(
                  "outcome: must be a result_descriptor, a failure or an analysis.");
        };
    int size =
        request.hasAnalysis() ? request.getAnalysis().getSerializedSize() : descriptor.length;
    return SubmitResultResponse.newBuilder()
        .setAccepted(accepted)
        .setSha256(request.getSha256())
        .setSize(size)
        .setLogSize(logs.size(key))
        .build();
  }

  private boolean deliver(AttemptKey key, byte[] document, String sha256) {
    String actual = StoredFiles.sha256(document);
    if (!actual.equals(sha256)) {
      throw RequestException.malformed(
          "sha256: is " + sha256 + ", but the document's is " + actual + ".");
    }
    return accepted(attempts.deliver(key, Results.read(document), document, sha256));
  }

  private boolean deliver(AttemptKey key, AnalysisReport report, String sha256) {
    byte[] encoded = report.toByteArray();
    String actual = StoredFiles.sha256(encoded);
    if (!actual.equals(sha256)) {
      throw RequestException.malformed(
          "sha256: is " + sha256 + ", but the analysis' is " + actual + ".");
    }
    disk.requireFor(encoded.length);
    return accepted(
        attempts.deliverAnalysis(
            key,
            AnalysisMessages.kind(report),
            json.writeValueAsBytes(AnalysisMessages.document(report)),
            sha256));
  }

  private static boolean accepted(Delivery delivery) {
    if (delivery == Delivery.ABANDONED) {
      throw io.grpc.Status.FAILED_PRECONDITION
          .withDescription("the attempt was abandoned")
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

  private static <T> void answer(StreamObserver<T> responses, Supplier<T> call) {
    T answer;
    try {
      answer = call.get();
    } catch (RuntimeException e) {
      responses.onError(GrpcStatus.exception(e));
      return;
    }
    responses.onNext(answer);
    responses.onCompleted();
  }

  /** Sends chunks when the stream is ready, so that they are not buffered in memory. */
  private static void sendChunks(
      byte[] content, ServerCallStreamObserver<DownloadFileResponse> responses) {
    Runnable onReady =
        new Runnable() {
          private int sent;
          private boolean done;

          @Override
          public void run() {
            while (!done && responses.isReady() && sent < content.length) {
              int size = Math.min(MAX_CHUNK, content.length - sent);
              responses.onNext(
                  DownloadFileResponse.newBuilder()
                      .setChunk(ByteString.copyFrom(content, sent, size))
                      .build());
              sent += size;
            }
            if (!done && sent == content.length) {
              done = true;
              responses.onCompleted();
            }
          }
        };
    responses.setOnReadyHandler(onReady);
  }
}
