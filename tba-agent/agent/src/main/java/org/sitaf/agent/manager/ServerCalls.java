package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import com.google.protobuf.Timestamp;
import com.google.protobuf.UnsafeByteOperations;
import io.grpc.Channel;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import io.grpc.stub.StreamObserver;
import java.io.IOException;
import java.io.OutputStream;
import java.time.Instant;
import java.util.Iterator;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.sitaf.agent.build.RecordingFile;
import org.sitaf.agent.v1.AgentServiceGrpc;
import org.sitaf.agent.v1.AppendLogRequest;
import org.sitaf.agent.v1.AttemptState;
import org.sitaf.agent.v1.CaseOutcome;
import org.sitaf.agent.v1.CaseSignals;
import org.sitaf.agent.v1.DownloadFileRequest;
import org.sitaf.agent.v1.DownloadFileResponse;
import org.sitaf.agent.v1.ReportCasesRequest;
import org.sitaf.agent.v1.ReportStateRequest;
import org.sitaf.agent.v1.SubmitResultRequest;
import org.sitaf.agent.v1.SubmitResultResponse;
import org.sitaf.agent.v1.UploadRecordingRequest;
import org.sitaf.agent.v1.UploadSignalsRequest;
import org.sitaf.agent.v1.UploadSignalsResponse;
import org.sitaf.core.digest.Sha256;

/**
 * Calls about an attempt, each with a deadline, so that a server that hangs counts as unavailable.
 */
final class ServerCalls {
  /** Largest chunk of a log, by the protocol. */
  static final int MAX_LOG_CHUNK = 64 * 1024;

  /** A message of this size is accepted by each server, whatever its release. */
  private static final int SMALLEST_LIMIT = 4 << 20;

  private static final int DEADLINE_S = 15;
  private static final int TRANSFER_DEADLINE_S = 120;

  private final Channel channel;

  ServerCalls(Channel channel) {
    this.channel = channel;
  }

  /** How to handle a failed call. */
  enum Failure {
    /** The server is unavailable or overloaded: retry. */
    LATER,
    /** The attempt has ended for this agent: discard its data. */
    OVER,
    /** The server rejects the request: do not retry. */
    REFUSED
  }

  static Failure meaningOf(StatusRuntimeException e) {
    return switch (e.getStatus().getCode()) {
      case FAILED_PRECONDITION, NOT_FOUND -> Failure.OVER;
      case INVALID_ARGUMENT, OUT_OF_RANGE, UNIMPLEMENTED -> Failure.REFUSED;
      default -> Failure.LATER;
    };
  }

  /** A status in one line, without stack trace. */
  static String describe(Status status) {
    StringBuilder text = new StringBuilder(status.getCode().name());
    String last = status.getDescription();
    if (last != null) {
      text.append(": ").append(last);
    }
    // The reason why a certificate is not trusted is a cause of a cause.
    for (Throwable cause = status.getCause(); cause != null; cause = cause.getCause()) {
      String message = cause.getMessage();
      if (message != null && !message.equals(last)) {
        text.append(": ").append(message);
        last = message;
      }
    }
    return text.toString();
  }

  void reportState(Attempt attempt, AttemptState state) {
    Instant now = Instant.now();
    stub(DEADLINE_S)
        .reportState(
            ReportStateRequest.newBuilder()
                .setAttempt(attempt.ref())
                .setState(state)
                .setTime(
                    Timestamp.newBuilder().setSeconds(now.getEpochSecond()).setNanos(now.getNano()))
                .build());
  }

  /**
   * Appends to the log and returns its new length in bytes; an empty chunk at 0 only returns the
   * length.
   */
  long appendLog(Attempt attempt, long offset, ByteString chunk) {
    return stub(DEADLINE_S)
        .appendLog(
            AppendLogRequest.newBuilder()
                .setAttempt(attempt.ref())
                .setOffset(offset)
                .setChunk(chunk)
                .build())
        .getNextOffset();
  }

  /**
   * Reports a batch of cases.
   *
   * @param sequence number of the batch in the attempt, from 1
   */
  void reportCases(Attempt attempt, long sequence, List<CaseOutcome> outcomes) {
    stub(DEADLINE_S)
        .reportCases(
            ReportCasesRequest.newBuilder()
                .setAttempt(attempt.ref())
                .setSequence(sequence)
                .addAllOutcomes(outcomes)
                .build());
  }

  /**
   * Uploads the recording of a case.
   *
   * @throws StatusRuntimeException as specified in the protocol; DATA_LOSS if the server confirms
   *     different content
   */
  void uploadRecording(Attempt attempt, RecordingFile file, byte[] gltf) {
    String sha256 = Sha256.hex(gltf);
    UploadRecordingRequest request =
        UploadRecordingRequest.newBuilder()
            .setAttempt(attempt.ref())
            .setCaseNo(file.no())
            .setRelation(file.relation())
            .setSha256(sha256)
            .build();
    String stored =
        send(
                UnsafeByteOperations.unsafeWrap(gltf),
                part -> request.toBuilder().setGltf(part).build(),
                stub(TRANSFER_DEADLINE_S)::uploadRecording,
                AgentServiceGrpc.newStub(channel)
                        .withDeadlineAfter(TRANSFER_DEADLINE_S, TimeUnit.SECONDS)
                    ::uploadRecordingInParts)
            .getSha256();
    if (!stored.equals(sha256)) {
      throw Status.DATA_LOSS
          .withDescription("the server confirmed different content")
          .asRuntimeException();
    }
  }

  /**
   * Uploads the signals of a case.
   *
   * @throws StatusRuntimeException as specified in the protocol
   */
  void uploadSignals(Attempt attempt, int caseNo, CaseSignals signals) {
    UploadSignalsResponse unused =
        stub(TRANSFER_DEADLINE_S)
            .uploadSignals(
                UploadSignalsRequest.newBuilder()
                    .setAttempt(attempt.ref())
                    .setCaseNo(caseNo)
                    .setSignals(signals)
                    .build());
  }

  /** Submits the result; the response tells what the server has stored and whether it counts. */
  SubmitResultResponse submit(SubmitResultRequest request) {
    if (!request.hasResultDescriptor()) {
      return stub(TRANSFER_DEADLINE_S).submitResult(request);
    }
    return send(
        request.getResultDescriptor(),
        part -> request.toBuilder().setResultDescriptor(part).build(),
        stub(TRANSFER_DEADLINE_S)::submitResult,
        AgentServiceGrpc.newStub(channel).withDeadlineAfter(TRANSFER_DEADLINE_S, TimeUnit.SECONDS)
            ::submitResultInParts);
  }

  /** Sends one message if it is small, or if the server does not support parts. */
  private static <Q, A> A send(
      ByteString whole,
      Function<ByteString, Q> message,
      Function<Q, A> atOnce,
      Function<StreamObserver<A>, StreamObserver<Q>> inChunks) {
    if (whole.size() > ChunkedCall.MAX_CHUNK) {
      try {
        return ChunkedCall.send(whole, message, inChunks);
      } catch (StatusRuntimeException e) {
        if (e.getStatus().getCode() != Status.Code.UNIMPLEMENTED) {
          throw e;
        }
      }
    }
    try {
      return atOnce.apply(message.apply(whole));
    } catch (StatusRuntimeException e) {
      if (whole.size() > SMALLEST_LIMIT
          && e.getStatus().getCode() == Status.Code.RESOURCE_EXHAUSTED) {
        // The same message would be refused each time.
        throw Status.INVALID_ARGUMENT
            .withDescription(
                "%d MiB are more than the server accepts, whose release knows no parts; update it"
                    .formatted(whole.size() >> 20))
            .withCause(e)
            .asRuntimeException();
      }
      throw e;
    }
  }

  /** Downloads a file of the attempt's test application, up to a size limit. */
  void download(Attempt attempt, String sha256, long atMost, OutputStream out) throws IOException {
    Iterator<DownloadFileResponse> chunks =
        stub(TRANSFER_DEADLINE_S)
            .downloadFile(
                DownloadFileRequest.newBuilder()
                    .setAttempt(attempt.ref())
                    .setSha256(sha256)
                    .build());
    long written = 0;
    while (chunks.hasNext()) {
      ByteString chunk = chunks.next().getChunk();
      written += chunk.size();
      if (written > atMost) {
        throw new IOException("the file exceeds the announced size of " + atMost + " bytes");
      }
      chunk.writeTo(out);
    }
  }

  private AgentServiceGrpc.AgentServiceBlockingStub stub(int deadlineSeconds) {
    return AgentServiceGrpc.newBlockingStub(channel)
        .withDeadlineAfter(deadlineSeconds, TimeUnit.SECONDS);
  }
}
