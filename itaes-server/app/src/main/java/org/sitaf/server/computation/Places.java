package org.sitaf.server.computation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.sitaf.server.refusal.Refusal;

/**
 * The places in which computations run, of which nobody gets more than a half while there are at
 * least two. A place is free again when the computation has really ended.
 */
final class Places {
  /** Requests of one person that may wait. */
  private static final int MAX_WAITING = 8;

  private final ReentrantLock lock = new ReentrantLock(true);
  private final Condition changed = lock.newCondition();
  private final List<Place> taken = new ArrayList<>();
  private final List<String> waiting = new ArrayList<>();
  private final int count;

  Places(int count) {
    this.count = count;
  }

  /** A place of somebody, with what ends the computation in it. */
  static final class Place {
    private final String owner;
    private volatile Runnable end = () -> {};

    private Place(String owner) {
      this.owner = owner;
    }

    /** Says how the computation is ended where a later one of its owner may replace it. */
    void replaceableBy(Runnable ending) {
      end = ending;
    }
  }

  /**
   * Waits for a place. Computations of the same owner that may be replaced are ended for it.
   *
   * @throws Refusal when there is none in time
   */
  Place take(String owner, boolean replaces, Duration patience) throws InterruptedException {
    long left = patience.toNanos();
    lock.lockInterruptibly();
    try {
      if (waiting.stream().filter(owner::equals).count() >= MAX_WAITING) {
        throw Refusal.busy(
            "You have "
                + MAX_WAITING
                + " requests that wait for a computation already; repeat this one later.");
      }
      waiting.add(owner);
      try {
        while (taken.size() >= count || ofOwner(owner).size() >= Math.max(1, count / 2)) {
          if (replaces) {
            ofOwner(owner).stream().findFirst().ifPresent(oldest -> oldest.end.run());
          }
          if (left <= 0) {
            throw Refusal.busy(
                "All "
                    + count
                    + " computations of this server, or your share of them, are taken; repeat the"
                    + " request later.");
          }
          left = changed.awaitNanos(left);
        }
      } finally {
        waiting.remove(owner);
      }
      Place place = new Place(owner);
      taken.add(place);
      return place;
    } finally {
      lock.unlock();
    }
  }

  void free(Place place) {
    lock.lock();
    try {
      taken.remove(place);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private List<Place> ofOwner(String owner) {
    return taken.stream().filter(p -> p.owner.equals(owner)).toList();
  }
}
