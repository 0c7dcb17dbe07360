package org.sitaf.server.build.agent;

import com.google.protobuf.ByteString;
import io.grpc.Status;
import io.grpc.stub.StreamObserver;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.server.error.RequestException;

/**
 * Receives a stream of chunks and joins them.
 *
 * @param <Q> the request message, which contains a chunk
 * @param <A> the response message
 */
final class ChunkedUpload<Q, A> implements StreamObserver<Q> {
  private static final long MAX_SIZE = 64L << 20;

  private final Fields<Q> fields;
  private final BiFunction<Q, byte[], A> handler;
  private final UploadMemory memory;
  private final StreamObserver<A> responses;
  private @Nullable Q first;
  private ByteString received = ByteString.EMPTY;
  private boolean ended;

  /** Getters of a message's fields. */
  record Fields<Q>(Function<Q, AttemptRef> attempt, Function<Q, ByteString> chunk) {}

  /**
   * Creates a receiver.
   *
   * @param handler computes the response from the first message and the joined chunks
   */
  ChunkedUpload(
      Fields<Q> fields,
      BiFunction<Q, byte[], A> handler,
      UploadMemory memory,
      StreamObserver<A> responses) {
    this.fields = fields;
    this.handler = handler;
    this.memory = memory;
    this.responses = responses;
  }

  @Override
  public void onNext(Q message) {
    if (ended) {
      return;
    }
    ByteString chunk = fields.chunk().apply(message);
    Q firstMessage = first == null ? message : first;
    first = firstMessage;
    if (!fields.attempt().apply(message).equals(fields.attempt().apply(firstMessage))) {
      fail(
          GrpcStatus.exception(
              RequestException.malformed("attempt: must be the same in all messages.")));
    } else if (received.size() + (long) chunk.size() > MAX_SIZE) {
      fail(GrpcStatus.exception(RequestException.tooLarge("The upload is larger than 64 MiB.")));
    } else if (memory.reserve(chunk.size())) {
      received = received.concat(chunk);
    } else {
      fail(
          Status.RESOURCE_EXHAUSTED
              .withDescription("the server has no memory for further uploads; try again later")
              .asRuntimeException());
    }
  }

  @Override
  public void onError(Throwable error) {
    end();
  }

  @Override
  public void onCompleted() {
    if (ended) {
      return;
    }
    A answer;
    try {
      if (first == null) {
        throw RequestException.malformed("The stream contains no message.");
      }
      answer = handler.apply(first, received.toByteArray());
    } catch (RuntimeException e) {
      fail(GrpcStatus.exception(e));
      return;
    }
    end();
    responses.onNext(answer);
    responses.onCompleted();
  }

  private void fail(Throwable why) {
    end();
    responses.onError(why);
  }

  private void end() {
    if (!ended) {
      ended = true;
      memory.release(received.size());
      received = ByteString.EMPTY;
    }
  }
}
