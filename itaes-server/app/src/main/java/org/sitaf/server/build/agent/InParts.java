package org.sitaf.server.build.agent;

import com.google.protobuf.ByteString;
import io.grpc.Status;
import io.grpc.stub.StreamObserver;
import java.util.function.BiFunction;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.v1.AttemptRef;
import org.sitaf.server.refusal.Refusal;

/**
 * Puts together what an agent sends in parts.
 *
 * @param <Q> a message that holds a part
 * @param <A> what answers the whole
 */
final class InParts<Q, A> implements StreamObserver<Q> {
  private static final long MOST = 64L << 20;

  private final Shape<Q> shape;
  private final BiFunction<Q, byte[], A> use;
  private final PartsMemory memory;
  private final StreamObserver<A> answers;
  private @Nullable Q first;
  private ByteString whole = ByteString.EMPTY;
  private boolean over;

  /** Where a message has what. */
  record Shape<Q>(Function<Q, AttemptRef> attempt, Function<Q, ByteString> part) {}

  /**
   * Begins with nothing.
   *
   * @param use answers the whole, with the first message
   */
  InParts(
      Shape<Q> shape, BiFunction<Q, byte[], A> use, PartsMemory memory, StreamObserver<A> answers) {
    this.shape = shape;
    this.use = use;
    this.memory = memory;
    this.answers = answers;
  }

  @Override
  public void onNext(Q message) {
    if (over) {
      return;
    }
    ByteString part = shape.part().apply(message);
    Q begun = first == null ? message : first;
    first = begun;
    if (!shape.attempt().apply(message).equals(shape.attempt().apply(begun))) {
      fail(StatusOf.exception(Refusal.malformed("attempt: must be the same in all parts.")));
    } else if (whole.size() + (long) part.size() > MOST) {
      fail(StatusOf.exception(Refusal.tooLarge("The whole is larger than 64 MiB.")));
    } else if (memory.take(part.size())) {
      whole = whole.concat(part);
    } else {
      fail(
          Status.RESOURCE_EXHAUSTED
              .withDescription("as much is on its way as the server has memory for")
              .asRuntimeException());
    }
  }

  @Override
  public void onError(Throwable broken) {
    end();
  }

  @Override
  public void onCompleted() {
    if (over) {
      return;
    }
    A answer;
    try {
      if (first == null) {
        throw Refusal.malformed("There is no part.");
      }
      answer = use.apply(first, whole.toByteArray());
    } catch (RuntimeException e) {
      fail(StatusOf.exception(e));
      return;
    }
    end();
    answers.onNext(answer);
    answers.onCompleted();
  }

  private void fail(Throwable why) {
    end();
    answers.onError(why);
  }

  private void end() {
    if (!over) {
      over = true;
      memory.giveBack(whole.size());
      whole = ByteString.EMPTY;
    }
  }
}
