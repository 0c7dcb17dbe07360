package org.sitaf.server.schedule.timing;

import java.text.ParseException;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.quartz.CronExpression;
import org.sitaf.server.error.RequestException;

/**
 * Converts cron expressions with five fields (minute, hour, day of month, month, day of week) to
 * Quartz's format, which has a field for seconds and an optional year. Expressions in Quartz's
 * format are accepted, too.
 */
final class CronText {
  private static final int FIELDS = 5;
  private static final List<String> DAYS =
      List.of("SUN", "MON", "TUE", "WED", "THU", "FRI", "SAT", "SUN");
  private static final Pattern DAY_NUMBER = Pattern.compile("(?<![/#\\w])[0-7](?!\\w)");

  private CronText() {}

  /**
   * Converts an expression to Quartz's format.
   *
   * @throws RequestException if the expression is invalid
   */
  static String toQuartz(String text) {
    String[] fields = text.strip().split("\\s+");
    String quartz = fields.length == FIELDS ? withSeconds(fields) : text.strip();
    try {
      CronExpression.validateExpression(quartz);
      return quartz;
    } catch (ParseException | RuntimeException e) {
      throw RequestException.malformed(
          "cron: '"
              + text
              + "' is not a cron expression ("
              + e.getMessage()
              + "); expected minute, hour, day of month, month and day of week, such as '0 3 * *"
              + " 1-5'.");
    }
  }

  /** Quartz requires '?' for one of the two day fields, and counts days of the week from 1. */
  private static String withSeconds(String[] fields) {
    String dayOfMonth = fields[2];
    String dayOfWeek = named(fields[4]);
    if (dayOfWeek.equals("*") || dayOfWeek.equals("?")) {
      dayOfWeek = "?";
      dayOfMonth = dayOfMonth.equals("?") ? "*" : dayOfMonth;
    } else if (dayOfMonth.equals("*") || dayOfMonth.equals("?")) {
      dayOfMonth = "?";
    } else {
      throw RequestException.malformed(
          "cron: give either the day of the month or the day of the week, and '*' for the other.");
    }
    return String.join(" ", "0", fields[0], fields[1], dayOfMonth, fields[3], dayOfWeek);
  }

  private static String named(String dayOfWeek) {
    Matcher matcher = DAY_NUMBER.matcher(dayOfWeek);
    return matcher.replaceAll(day -> DAYS.get(Integer.parseInt(day.group())));
  }
}
