package org.sitaf.server.webhook;

import com.fasterxml.jackson.annotation.JsonCreator;
import com.fasterxml.jackson.annotation.JsonValue;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.server.error.RequestException;

/** What a webhook can report. */
enum WebhookEvent {
  /** A build has ended. */
  BUILD_FINISHED("build.finished"),
  /** The builds of a commit were requested. */
  COMMIT_STARTED("commit.started"),
  /** A commit has its final status. */
  COMMIT_FINISHED("commit.finished");

  private final String text;

  WebhookEvent(String text) {
    this.text = text;
  }

  /** As messages, requests and the database write it. */
  @JsonValue
  String text() {
    return text;
  }

  /** The event that is written as this text. */
  @JsonCreator
  static WebhookEvent of(String text) {
    return Arrays.stream(values())
        .filter(event -> event.text.equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                RequestException.malformed(
                    "events: \""
                        + text
                        + "\" is no event. Events are "
                        + joined(EnumSet.allOf(WebhookEvent.class), ", ")
                        + "."));
  }

  /** Reads what {@link #stored} wrote. */
  static Set<WebhookEvent> read(String stored) {
    return Arrays.stream(stored.split(","))
        .map(WebhookEvent::of)
        .collect(Collectors.toCollection(() -> EnumSet.noneOf(WebhookEvent.class)));
  }

  /** A set of events for the database. */
  static String stored(Set<WebhookEvent> events) {
    return joined(events, ",");
  }

  private static String joined(Set<WebhookEvent> events, String separator) {
    return events.stream().map(WebhookEvent::text).collect(Collectors.joining(separator));
  }
}
