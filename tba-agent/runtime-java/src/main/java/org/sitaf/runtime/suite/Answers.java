package org.sitaf.runtime.suite;

import java.time.Duration;
import java.util.Map;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/** Answers of a stubbed method in a case, one per call; the last answer repeats. */
public final class Answers<T> {
  private final Answer<T> unset;
  private final TreeMap<Integer, Answer<T>> fromCall;

  Answers(@Nullable T unset, Map<Integer, Answer<T>> fromCall) {
    this.unset = new Answer<>(Duration.ZERO, null, unset);
    this.fromCall = new TreeMap<>(fromCall);
  }

  /** The same value in every call. */
  public static <T> Answers<T> none(@Nullable T unset) {
    return new Answers<>(unset, Map.of());
  }

  /** The answer of a call, counted from 1. */
  public Answer<T> of(int call) {
    Map.Entry<Integer, Answer<T>> entry = fromCall.floorEntry(call);
    return entry == null ? unset : entry.getValue();
  }
}
