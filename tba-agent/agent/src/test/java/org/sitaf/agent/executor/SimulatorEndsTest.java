package org.sitaf.agent.executor;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sitaf.agent.executor.SimulatorEnds.Next;
import org.sitaf.agent.simulation.SimulatorEnd;

class SimulatorEndsTest {
  private static final SimulatorEnd KILLED = new SimulatorEnd("it ended with exit code 137", false);
  private static final SimulatorEnd TOO_LARGE = new SimulatorEnd("it used too much", true);

  private final SimulatorEnds ends = new SimulatorEnds(2, 3);

  @Test
  void aSingleEndIsNotTheFaultOfTheCase() {
    assertThat(ends.after(1, true, KILLED).next()).isEqualTo(Next.TRY_AGAIN);
    assertThat(ends.after(2, true, KILLED).next()).isEqualTo(Next.TRY_AGAIN);
  }

  @Test
  void twoEndsInACaseAreItsFault() {
    assertThat(ends.after(7, true, KILLED).next()).isEqualTo(Next.TRY_AGAIN);
    SimulatorEnds.Consequence second = ends.after(7, true, KILLED);
    assertThat(second.next()).isEqualTo(Next.BLAME_CASE);
    assertThat(second.message()).contains("case 7", "exit code 137", "each time in this case");
  }

  @Test
  void exceedingALimitIsTheFaultOfTheCase() {
    SimulatorEnds.Consequence consequence = ends.after(7, true, TOO_LARGE);
    assertThat(consequence.next()).isEqualTo(Next.BLAME_CASE);
    assertThat(consequence.message()).contains("it used too much");
  }

  @Test
  void anEndBeforeTheFirstCaseIsNotTheFaultOfACase() {
    assertThat(ends.after(1, false, TOO_LARGE).next()).isEqualTo(Next.TRY_AGAIN);
    assertThat(ends.after(1, false, TOO_LARGE).next()).isEqualTo(Next.TRY_AGAIN);
  }

  @Test
  void failsABuildThatCrashesItsSimulatorsRepeatedly() {
    for (int no = 1; no <= 3; no++) {
      assertThat(ends.after(no, true, KILLED).next()).isEqualTo(Next.TRY_AGAIN);
    }
    SimulatorEnds.Consequence last = ends.after(4, true, KILLED);
    assertThat(last.next()).isEqualTo(Next.GIVE_UP);
    assertThat(last.message()).contains("4 times");
  }
}
