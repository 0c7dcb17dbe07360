package org.sitaf.server.computation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CountDownLatch;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.sitaf.core.expression.EvaluationException;
import org.sitaf.core.expression.ExpressionCompiler;
import org.sitaf.server.access.Caller;
import org.sitaf.server.access.Role;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.springframework.security.core.context.SecurityContextHolder;

class ComputationsTest {
  private static final Duration SHORT = Duration.ofMillis(300);
  private static final Duration LONG = Duration.ofMinutes(10);

  private @Nullable Computations running;

  @AfterEach
  void stop() {
    if (running != null) {
      running.stop();
    }
  }

  @Test
  void timedOutComputationIsCancelledAndReleasesItsPermit() {
    Computations computations = computations(1, SHORT, LONG);
    for (int i = 0; i < 3; i++) {
      CountDownLatch ended = new CountDownLatch(1);
      assertThatThrownBy(
              () -> as("eve", () -> computations.generation("It", () -> evaluate(ended))))
          .isInstanceOf(ComputationTimeoutException.class)
          .hasMessageContaining("took longer than");
      await(ended);
    }
    assertThat(as("adam", () -> computations.generation("It", () -> 1))).isEqualTo(1);
  }

  @Test
  void permitsAreSharedFairly() {
    Computations computations = computations(4, LONG, Duration.ZERO);
    CountDownLatch started = new CountDownLatch(2);
    CountDownLatch ended = new CountDownLatch(2);
    List<CompletableFuture<Integer>> heavy =
        List.of(
            later("eve", computations, started, ended), later("eve", computations, started, ended));
    await(started);
    assertThatThrownBy(() -> as("eve", () -> computations.generation("It", () -> 1)))
        .isInstanceOfSatisfying(
            RequestException.class,
            e -> assertThat(e.reason()).isEqualTo(RequestException.Reason.BUSY));
    assertThat(as("adam", () -> computations.generation("It", () -> 2))).isEqualTo(2);
    assertThat(as("adam", () -> computations.preview("It", () -> 3, () -> {}))).isEqualTo(3);

    computations.stop();
    await(ended);
    for (CompletableFuture<Integer> each : heavy) {
      assertThatThrownBy(each::join)
          .isInstanceOf(CompletionException.class)
          .hasMessageContaining("the server is stopping");
    }
  }

  @Test
  void laterPreviewOfTheSameUserReplacesTheEarlierOne() {
    Computations computations = computations(2, LONG, LONG);
    CountDownLatch started = new CountDownLatch(1);
    CountDownLatch ended = new CountDownLatch(1);
    CompletableFuture<Integer> earlier =
        CompletableFuture.supplyAsync(
            () ->
                as(
                    "eve",
                    () ->
                        computations.preview(
                            "It",
                            () -> {
                              started.countDown();
                              return evaluate(ended);
                            },
                            () -> {})));
    await(started);
    assertThat(as("eve", () -> computations.preview("It", () -> 5, () -> {}))).isEqualTo(5);
    await(ended);
    assertThatThrownBy(earlier::join).hasMessageContaining("you sent a later request");
  }

  @Test
  void aPreviewIsCancelledWhenItsClientDisconnects() {
    Computations computations = computations(1, LONG, LONG);
    CountDownLatch ended = new CountDownLatch(1);
    assertThatThrownBy(
            () ->
                as(
                    "eve",
                    () ->
                        computations.preview(
                            "It",
                            () -> evaluate(ended),
                            () -> {
                              throw RequestException.busy("gone");
                            })))
        .hasMessage("gone");
    await(ended);
    assertThat(as("adam", () -> computations.generation("It", () -> 1))).isEqualTo(1);
  }

  private static CompletableFuture<Integer> later(
      String name, Computations computations, CountDownLatch started, CountDownLatch ended) {
    return CompletableFuture.supplyAsync(
        () ->
            as(
                name,
                () ->
                    computations.generation(
                        "It",
                        () -> {
                          started.countDown();
                          return evaluate(ended);
                        })));
  }

  /** Does not end until it is interrupted. */
  private static int evaluate(CountDownLatch ended) {
    String digits = "[0,1,2,3,4,5,6,7,8,9]";
    String nested = digits + ".all(a, " + digits + ".all(b, " + digits + ".all(c, a < 10)))";
    var expression = new ExpressionCompiler(Set.of()).compile(nested);
    try {
      while (true) {
        expression.evaluate(java.util.Map.of());
      }
    } catch (EvaluationException e) {
      throw new IllegalStateException(e);
    } finally {
      ended.countDown();
    }
  }

  private Computations computations(int permits, Duration limit, Duration wait) {
    Computations computations =
        new Computations(new ComputationSettings(permits, limit, limit, wait));
    computations.start();
    running = computations;
    return computations;
  }

  private static <T> T as(String name, Supplier<T> work) {
    SecurityContextHolder.getContext()
        .setAuthentication(
            new Caller(name, Role.values()[0], Caller.Kind.PERSON, name).authentication());
    try {
      return work.get();
    } finally {
      SecurityContextHolder.clearContext();
    }
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
