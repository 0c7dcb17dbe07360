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
import org.sitaf.server.error.RequestException;

/** Days on which a schedule does not fire. */
public record ExcludedDays(Set<LocalDate> days, Set<DayOfWeek> weekdays) {
  private static final int MAX_DAYS = 5000;
  private static final int DAYS_OF_WEEK = 7;

  public ExcludedDays {
    days = java.util.Collections.unmodifiableSet(new TreeSet<>(days));
    weekdays = java.util.Collections.unmodifiableSet(new TreeSet<>(weekdays));
    if (days.size() > MAX_DAYS) {
      throw RequestException.malformed("days: must be at most " + MAX_DAYS + " days.");
    }
    if (weekdays.size() == DAYS_OF_WEEK) {
      throw RequestException.malformed(
          "weekdays: must be at most six, or the schedule would never fire.");
    }
  }

  /** The union of several sets of days. */
  public static ExcludedDays union(Collection<ExcludedDays> all) {
    Set<LocalDate> days = new TreeSet<>();
    Set<DayOfWeek> weekdays = new TreeSet<>();
    all.forEach(
        one -> {
          days.addAll(one.days());
          weekdays.addAll(one.weekdays());
        });
    return new ExcludedDays(days, weekdays);
  }

  /** Converts the days to a calendar of Quartz in a time zone. */
  public Calendar toQuartz(ZoneId zone) {
    TimeZone timeZone = TimeZone.getTimeZone(zone);
    WeeklyCalendar weekly = new WeeklyCalendar(timeZone);
    weekly.setDaysExcluded(new boolean[DAYS_OF_WEEK + 1]);
    // In Quartz Sunday is 1.
    weekdays.forEach(day -> weekly.setDayExcluded(day.getValue() % DAYS_OF_WEEK + 1, true));
    HolidayCalendar holidays = new HolidayCalendar(weekly, timeZone);
    days.forEach(day -> holidays.addExcludedDate(Date.from(day.atStartOfDay(zone).toInstant())));
    return holidays;
  }
}
