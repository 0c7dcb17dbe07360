package org.sitaf.server.web;

import java.util.HashMap;
import java.util.Map;
import org.springframework.stereotype.Component;

/**
 * Each body that is waited for holds a thread. There are places for fewer bodies than there are
 * threads, fewer still for those of strangers, and nobody gets all of them.
 */
@Component
class BodyPlaces {
  private static final int OF_STRANGERS = 32;
  private static final int OF_A_STRANGER = 8;
  private static final int OF_CALLERS = 96;
  private static final int OF_A_CALLER = 12;

  private final Map<Waiter, Integer> taken = new HashMap<>();
  private int strangers;
  private int callers;

  /**
   * Who waits.
   *
   * @param name of the caller, or the address of a stranger
   */
  record Waiter(String name, boolean stranger) {}

  /** Whether there was a place, which is taken then. */
  synchronized boolean take(Waiter waiter) {
    int own = taken.getOrDefault(waiter, 0);
    boolean free =
        waiter.stranger()
            ? strangers < OF_STRANGERS && own < OF_A_STRANGER
            : callers < OF_CALLERS && own < OF_A_CALLER;
    if (free) {
      taken.put(waiter, own + 1);
      count(waiter, 1);
    }
    return free;
  }

  /** Gives a place back. */
  synchronized void leave(Waiter waiter) {
    taken.computeIfPresent(waiter, (key, own) -> own == 1 ? null : own - 1);
    count(waiter, -1);
  }

  private void count(Waiter waiter, int more) {
    if (waiter.stranger()) {
      strangers += more;
    } else {
      callers += more;
    }
  }
}
