package org.sitaf.agent.manager;

import com.google.protobuf.ByteString;
import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import io.grpc.stub.ClientCallStreamObserver;
import io.grpc.stub.ClientResponseObserver;
import io.grpc.stub.StreamObserver;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.function.Function;

/**
 * Sends a large message in chunks, as fast as the server accepts them.
 *
 * @param <Q> request message that holds a chunk
 * @param <A> response to the whole message
 */
final class ChunkedCall<Q, A> implements ClientResponseObserver<Q, A> {
  /** Size of the largest chunk in bytes, by the protocol. */
  static final int MAX_CHUNK = 1 << 20;

  private final ByteString whole;
  private final Function<ByteString, Q> message;
  private final CompletableFuture<A> answer = new CompletableFuture<>();
  private int sent;
  private boolean done;

  private ChunkedCall(ByteString whole, Function<ByteString, Q> message) {
    this.whole = whole;
    this.message = message;
  }

  /**
   * Makes a call and waits for its response.
   *
   * @throws StatusRuntimeException as specified in the protocol
   */
  static <Q, A> A send(
      ByteString whole,
      Function<ByteString, Q> message,
      Function<StreamObserver<A>, StreamObserver<Q>> method) {
    ChunkedCall<Q, A> call = new ChunkedCall<>(whole, message);
    var unused = method.apply(call);
    try {
      return call.answer.join();
    } catch (CompletionException e) {
      throw Status.fromThrowable(e).asRuntimeException();
    }
  }

  @Override
  public void beforeStart(ClientCallStreamObserver<Q> requests) {
    requests.setOnReadyHandler(() -> sendTo(requests));
  }

  private synchronized void sendTo(ClientCallStreamObserver<Q> requests) {
    while (!done && requests.isReady()) {
      int end = Math.min(whole.size(), sent + MAX_CHUNK);
      requests.onNext(message.apply(whole.substring(sent, end)));
      sent = end;
      if (sent == whole.size()) {
        done = true;
        requests.onCompleted();
      }
    }
  }

  @Override
  public void onNext(A response) {
    answer.complete(response);
  }

  @Override
  public void onError(Throwable failure) {
    answer.completeExceptionally(failure);
  }

  @Override
  public void onCompleted() {
    answer.completeExceptionally(
        Status.INTERNAL.withDescription("the server sent no response").asRuntimeException());
  }
}
