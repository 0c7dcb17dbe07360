package org.sitaf.server.schedule.timing;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.Instant;
import java.time.LocalDate;
import java.time.OffsetDateTime;
import java.time.ZoneId;
import java.time.ZoneOffset;
import java.util.Date;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.quartz.TriggerUtils;
import org.quartz.spi.OperableTrigger;
import org.sitaf.server.error.RequestException;

class TimingTest {
  private static final ZoneId SEOUL = ZoneId.of("Asia/Seoul");

  @Test
  void fiveFieldCronIsConvertedToQuartz() {
    assertThat(CronText.toQuartz("0 3 * * 1-5")).isEqualTo("0 0 3 ? * MON-FRI");
    assertThat(CronText.toQuartz("*/15 * 1,15 * *")).isEqualTo("0 */15 * 1,15 * ?");
    assertThat(CronText.toQuartz("0 0 * * 7")).isEqualTo("0 0 0 ? * SUN");
    assertThat(CronText.toQuartz("0 0 12 ? * 6#3")).isEqualTo("0 0 12 ? * 6#3");
    assertThatThrownBy(() -> CronText.toQuartz("61 * * * *")).isInstanceOf(RequestException.class);
  }

  @Test
  void daysAreExcludedInTheZoneOfTheSchedule() {
    ExcludedDays excluded =
        new ExcludedDays(Set.of(LocalDate.of(2027, 1, 1)), Set.of(DayOfWeek.SATURDAY));
    OperableTrigger trigger =
        (OperableTrigger)
            new Timing.Cron("30 0 * * *", SEOUL)
                .trigger(Misfire.ONCE)
                .startAt(Date.from(Instant.parse("2026-12-30T15:00:00Z")))
                .build();
    List<LocalDate> days =
        TriggerUtils.computeFireTimes(trigger, excluded.toQuartz(SEOUL), 3).stream()
            .map(time -> time.toInstant().atZone(SEOUL).toLocalDate())
            .toList();
    assertThat(days)
        .containsExactly(
            LocalDate.of(2026, 12, 31), LocalDate.of(2027, 1, 3), LocalDate.of(2027, 1, 4));
  }

  @Test
  void misfirePolicyAppliesToPeriodicSchedules() {
    Instant from = Instant.now().minus(Duration.ofMinutes(95));
    for (Timing timing :
        List.of(
            new Timing.Interval(10, from, ZoneOffset.UTC),
            new Timing.Cron("*/10 * * * *", ZoneOffset.UTC))) {
      Instant before = Instant.now();
      assertThat(afterMisfire(timing, Misfire.SKIP, from)).isAfter(before);
      assertThat(afterMisfire(timing, Misfire.ONCE, from))
          .isBetween(before.minusSeconds(1), Instant.now().plusSeconds(1));
      assertThat(misfireInstruction(timing, Misfire.ALL))
          .as("fires each of them")
          .isEqualTo(org.quartz.Trigger.MISFIRE_INSTRUCTION_IGNORE_MISFIRE_POLICY);
    }
  }

  @Test
  void misfirePolicyAppliesToReservations() {
    OffsetDateTime at = OffsetDateTime.now(ZoneOffset.UTC).minusHours(1);
    Timing timing = new Timing.Reserved(at);
    OperableTrigger skipped = (OperableTrigger) timing.trigger(Misfire.SKIP).build();
    skipped.computeFirstFireTime(null);
    skipped.updateAfterMisfire(null);
    assertThat(skipped.getNextFireTime()).isNull();
    assertThat(misfireInstruction(timing, Misfire.ONCE))
        .isEqualTo(org.quartz.Trigger.MISFIRE_INSTRUCTION_IGNORE_MISFIRE_POLICY);
  }

  @Test
  void excludingAllWeekdaysIsRejected() {
    assertThatThrownBy(() -> new ExcludedDays(Set.of(), Set.of(DayOfWeek.values())))
        .hasMessageContaining("would never fire");
  }

  private static Instant afterMisfire(Timing timing, Misfire misfire, Instant from) {
    OperableTrigger trigger =
        (OperableTrigger) timing.trigger(misfire).startAt(Date.from(from)).build();
    trigger.computeFirstFireTime(null);
    trigger.updateAfterMisfire(null);
    return trigger.getNextFireTime().toInstant();
  }

  private static int misfireInstruction(Timing timing, Misfire misfire) {
    return timing.trigger(misfire).build().getMisfireInstruction();
  }
}
