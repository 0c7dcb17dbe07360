package org.sitaf.core.verdict.document;

import java.util.Arrays;
import java.util.List;
import java.util.stream.Collectors;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.timing.RepeatedCalls;
import org.sitaf.schemas.RepeatedCallsType;

/** The repeated calls of a case in a result. */
final class RepeatedCallsXml {
  /** Longer than the times of all samples. */
  private static final int MAX_TEXT = RepeatedCalls.MAX_SAMPLES * 30;

  private RepeatedCallsXml() {}

  /**
   * Reads the element.
   *
   * @throws IllegalArgumentException if its numbers are contradictory
   */
  static @Nullable RepeatedCalls read(@Nullable RepeatedCallsType given) {
    if (given == null) {
      return null;
    }
    return new RepeatedCalls(
        given.getWarmUp(),
        given.getCalls(),
        given.getMedian(),
        given.getLow(),
        given.getHigh(),
        samples(given.getSamples() == null ? "" : given.getSamples()),
        given.getDiffers() == null ? "" : given.getDiffers());
  }

  private static List<Double> samples(String text) {
    if (text.length() > MAX_TEXT) {
      throw new IllegalArgumentException(
          "repeated_calls must have at most " + RepeatedCalls.MAX_SAMPLES + " samples");
    }
    try {
      return Arrays.stream(text.split(" ")).filter(t -> !t.isEmpty()).map(Double::valueOf).toList();
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("repeated_calls must have numbers as samples", e);
    }
  }

  static @Nullable RepeatedCallsType write(@Nullable RepeatedCalls repeated) {
    if (repeated == null) {
      return null;
    }
    RepeatedCallsType written = new RepeatedCallsType();
    written.setWarmUp(repeated.warmUp());
    written.setCalls(repeated.calls());
    written.setMedian(repeated.median());
    written.setLow(repeated.low());
    written.setHigh(repeated.high());
    written.setSamples(
        repeated.samples().stream().map(String::valueOf).collect(Collectors.joining(" ")));
    written.setDiffers(repeated.differ() ? repeated.differs() : null);
    return written;
  }
}
