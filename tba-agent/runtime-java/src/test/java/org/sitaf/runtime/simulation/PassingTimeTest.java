package org.sitaf.runtime.simulation;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;

class PassingTimeTest {
  private static final long STEP_NANOS = 2_000_000;
  private final AtomicLong now = new AtomicLong();
  private final PassingTime time = new PassingTime(STEP_NANOS, now::addAndGet);

  @Test
  void ticksAtTheFirstStepAtOrAfterEachPeriodWithoutDrift() {
    List<Long> ticks = new ArrayList<>();
    time.every(Duration.ofMillis(5), () -> ticks.add(now.get()));

    time.pass(Duration.ofMillis(13));
    assertThat(now.get()).isEqualTo(7);
    time.pass(Duration.ofMillis(6));

    // 5, 10, 15 and 20 ms in steps of 2 ms.
    assertThat(ticks).containsExactly(3L, 5L, 8L, 10L);
  }

  @Test
  void ticksOncePerPeriodOfWholeSteps() {
    List<Long> ticks = new ArrayList<>();
    time.every(Duration.ofMillis(10), () -> ticks.add(now.get()));

    time.pass(Duration.ofSeconds(1));

    assertThat(ticks).hasSize(100).startsWith(5L, 10L, 15L).endsWith(500L);
  }

  @Test
  void skipsTicksDuringASleepOfATick() {
    List<Long> ticks = new ArrayList<>();
    time.every(
        Duration.ofMillis(10),
        () -> {
          ticks.add(now.get());
          time.pass(Duration.ofMillis(12));
        });

    time.pass(Duration.ofMillis(50));

    assertThat(ticks).containsExactly(5L, 15L, 25L);
  }

  @Test
  void throwsExceptionsOfTicksUnchanged() {
    time.every(
        Duration.ofMillis(10),
        () -> {
          throw new IOException("no bus");
        });

    assertThatThrownBy(() -> time.pass(Duration.ofMillis(50)))
        .isExactlyInstanceOf(IOException.class)
        .hasMessage("no bus");
    assertThat(now.get()).isEqualTo(5);
  }

  @Test
  void stopsTicksWhenANewCaseStarts() {
    List<Long> ticks = new ArrayList<>();
    time.every(Duration.ofMillis(10), () -> ticks.add(now.get()));

    time.restart(Duration.ZERO);
    time.pass(Duration.ofMillis(50));

    assertThat(ticks).isEmpty();
    assertThatThrownBy(() -> time.every(Duration.ZERO, () -> {}))
        .isInstanceOf(IllegalArgumentException.class);
  }

  @Test
  void runsAFollowedThreadAtTheSameTimesInEveryRun() throws Exception {
    List<Long> acted = Collections.synchronizedList(new ArrayList<>());
    Thread component = beginFollowed(() -> act(acted, 5));

    time.pass(Duration.ofMillis(20));
    assertThat(acted).containsExactly(0L, 3L, 6L, 9L);
    time.pass(Duration.ofMillis(100));
    component.join();

    assertThat(acted).containsExactly(0L, 3L, 6L, 9L, 12L);
    assertThat(now.get()).isEqualTo(60);
  }

  @Test
  void letsTimePassUntilTheFollowedThreadLeaves() throws Exception {
    List<Long> acted = Collections.synchronizedList(new ArrayList<>());
    Thread component = beginFollowed(() -> act(acted, 5));

    time.pass(Duration.ofMillis(4));
    time.passUntilLeaves(component);
    component.join();

    assertThat(acted).containsExactly(0L, 3L, 6L, 9L, 12L);
    assertThat(now.get()).isEqualTo(15);
    time.passUntilLeaves(component);
    assertThat(now.get()).isEqualTo(15);
  }

  @Test
  void endsTheWaitsOfAFollowedThreadThatIsGivenUp() throws Exception {
    List<Long> acted = Collections.synchronizedList(new ArrayList<>());
    List<Throwable> thrown = Collections.synchronizedList(new ArrayList<>());
    Thread component =
        beginFollowed(
            () -> {
              try {
                act(acted, Integer.MAX_VALUE);
              } catch (SimulationException e) {
                thrown.add(e);
              }
            });
    time.limit(Duration.ofMillis(20));

    assertThatThrownBy(() -> time.passUntilLeaves(component))
        .isInstanceOf(CaseTooLongException.class)
        .hasMessage("the case took more than 0.02 s of simulation time");
    time.giveUp(component);
    component.join();

    assertThat(acted).containsExactly(0L, 3L, 6L, 9L);
    assertThat(thrown).singleElement().asString().contains("the case has ended");
  }

  @Test
  void wakesFollowedThreadsInTheOrderOfTheirBeginning() throws Exception {
    List<String> acted = Collections.synchronizedList(new ArrayList<>());
    List<Thread> components = new ArrayList<>();
    for (String name : List.of("first", "second", "third")) {
      components.add(
          beginFollowed(
              () -> {
                for (int i = 0; i < 3; i++) {
                  time.pass(Duration.ofMillis(6));
                  // The others would act meanwhile if they ran at the same time.
                  Thread.yield();
                  acted.add(name + " " + now.get());
                  Thread.yield();
                }
              }));
      time.awaitTurnOf(components.get(components.size() - 1));
    }

    for (Thread component : components) {
      time.passUntilLeaves(component);
    }

    assertThat(acted)
        .containsExactly(
            "first 3",
            "second 3",
            "third 3",
            "first 6",
            "second 6",
            "third 6",
            "first 9",
            "second 9",
            "third 9");
  }

  @Test
  void letsAFollowedThreadWaitUntilAnotherLeaves() throws Exception {
    List<Long> acted = Collections.synchronizedList(new ArrayList<>());
    Thread[] inner = new Thread[1];
    Thread outer =
        beginFollowed(
            () -> {
              inner[0] = beginFollowed(() -> act(acted, 2));
              time.awaitTurnOf(inner[0]);
              time.passUntilLeaves(inner[0]);
              acted.add(-now.get());
            });

    time.passUntilLeaves(outer);
    outer.join();

    assertThat(acted).containsExactly(0L, 3L, -6L);
  }

  @Test
  void countsTheSettleTimeTowardsTheLimit() {
    time.limit(Duration.ofMillis(20));
    time.restart(Duration.ofMillis(12));

    time.pass(Duration.ofMillis(8));

    assertThatThrownBy(() -> time.pass(Duration.ofMillis(2)))
        .isInstanceOf(CaseTooLongException.class);
  }

  private Thread beginFollowed(Runnable work) {
    Thread component =
        new Thread(
            () -> {
              try {
                work.run();
              } finally {
                time.leave();
              }
            });
    time.follow(component);
    component.start();
    return component;
  }

  private void act(List<Long> acted, int times) {
    for (int i = 0; i < times; i++) {
      acted.add(now.get());
      time.pass(Duration.ofMillis(6));
    }
  }
}
