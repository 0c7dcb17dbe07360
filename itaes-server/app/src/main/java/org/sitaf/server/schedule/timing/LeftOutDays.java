package org.sitaf.server.schedule.timing;

import java.time.DayOfWeek;
import java.time.LocalDate;
import java.time.ZoneId;
import java.util.Collection;
import java.util.Date;
import java.util.Set;
import java.util.TimeZone;
import java.util.TreeSet;
import org.quartz.Calendar;
import org.quartz.impl.calendar.HolidayCalendar;
import org.quartz.impl.calendar.WeeklyCalendar;
import org.sitaf.server.refusal.Refusal;

/** Days on which nothing fires. */
public record LeftOutDays(Set<LocalDate> days, Set<DayOfWeek> weekdays) {
  private static final int MAX_DAYS = 5000;
  private static final int DAYS_OF_WEEK = 7;

  public LeftOutDays {
    days = java.util.Collections.unmodifiableSet(new TreeSet<>(days));
    weekdays = java.util.Collections.unmodifiableSet(new TreeSet<>(weekdays));
    if (days.size() > MAX_DAYS) {
      throw Refusal.malformed("days: at most " + MAX_DAYS + ".");
    }
    if (weekdays.size() == DAYS_OF_WEEK) {
      throw Refusal.malformed("weekdays: nothing would ever fire; leave out at most six.");
    }
  }

  /** All days of several. */
  public static LeftOutDays union(Collection<LeftOutDays> all) {
    Set<LocalDate> days = new TreeSet<>();
    Set<DayOfWeek> weekdays = new TreeSet<>();
    all.forEach(
        one -> {
          days.addAll(one.days());
          weekdays.addAll(one.weekdays());
        });
    return new LeftOutDays(days, weekdays);
  }

  /** As Quartz has it, for schedules of a zone. */
  public Calendar toQuartz(ZoneId zone) {
    TimeZone timeZone = TimeZone.getTimeZone(zone);
    WeeklyCalendar weekly = new WeeklyCalendar(timeZone);
    weekly.setDaysExcluded(new boolean[DAYS_OF_WEEK + 1]);
    // Quartz counts from Sunday, 1.
    weekdays.forEach(day -> weekly.setDayExcluded(day.getValue() % DAYS_OF_WEEK + 1, true));
    HolidayCalendar holidays = new HolidayCalendar(weekly, timeZone);
    days.forEach(day -> holidays.addExcludedDate(Date.from(day.atStartOfDay(zone).toInstant())));
    return holidays;
  }
}
