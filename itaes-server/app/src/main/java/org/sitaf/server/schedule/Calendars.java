package org.sitaf.server.schedule;

import java.time.DayOfWeek;
import java.time.LocalDate;
import java.util.Collection;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.schedule.timing.ExcludedDays;
import org.springframework.jdbc.core.simple.JdbcClient;
import org.springframework.stereotype.Repository;

/** Named sets of days on which schedules do not fire. */
@Repository
class Calendars {
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9._-]{1,100}");

  private final JdbcClient jdbc;

  Calendars(JdbcClient jdbc) {
    this.jdbc = jdbc;
  }

  Map<String, ExcludedDays> all() {
    Map<String, ExcludedDays> calendars = new TreeMap<>();
    jdbc.sql("SELECT name, days, weekdays FROM calendar")
        .query(
            (row, index) ->
                calendars.put(
                    row.getString(1),
                    new ExcludedDays(
                        words(row.getString(2), LocalDate::parse),
                        words(row.getString(3), DayOfWeek::valueOf))))
        .list();
    return calendars;
  }

  ExcludedDays find(String name) {
    return Optional.ofNullable(all().get(name))
        .orElseThrow(() -> RequestException.notFound("calendar", name));
  }

  /** The excluded days of several calendars. */
  ExcludedDays union(Collection<String> names) {
    return ExcludedDays.union(names.stream().map(this::find).toList());
  }

  void save(String name, ExcludedDays calendar) {
    if (!NAME.matcher(name).matches()) {
      throw RequestException.malformed("name: must be 1 to 100 letters, digits, '.', '_' or '-'.");
    }
    delete(name);
    jdbc.sql("INSERT INTO calendar (name, days, weekdays) VALUES (?, ?, ?)")
        .params(name, text(calendar.days()), text(calendar.weekdays()))
        .update();
  }

  /** Returns false if there is no such calendar. */
  boolean delete(String name) {
    return jdbc.sql("DELETE FROM calendar WHERE name = ?").param(name).update() > 0;
  }

  private static String text(Collection<?> values) {
    return values.stream().map(Object::toString).collect(Collectors.joining(" "));
  }

  private static <T> Set<T> words(String text, Function<String, T> parse) {
    return Stream.of(text.split(" "))
        .filter(word -> !word.isEmpty())
        .map(parse)
        .collect(Collectors.toUnmodifiableSet());
  }
}
