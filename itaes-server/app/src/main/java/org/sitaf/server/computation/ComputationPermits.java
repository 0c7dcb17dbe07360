package org.sitaf.server.computation;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.locks.Condition;
import java.util.concurrent.locks.ReentrantLock;
import org.sitaf.server.error.RequestException;

/**
 * Permits for concurrent computations. A user gets at most half of them, but at least one. A permit
 * is released when the computation has ended, even if its request ended earlier.
 */
final class ComputationPermits {
  /** Maximum number of waiting requests per user. */
  private static final int MAX_WAITING = 8;

  private final ReentrantLock lock = new ReentrantLock(true);
  private final Condition changed = lock.newCondition();
  private final List<Permit> taken = new ArrayList<>();
  private final List<String> waiting = new ArrayList<>();
  private final int count;

  ComputationPermits(int count) {
    this.count = count;
  }

  /** A permit, and how to cancel the computation that holds it. */
  static final class Permit {
    private final String owner;
    private volatile Runnable cancel = () -> {};

    private Permit(String owner) {
      this.owner = owner;
    }

    /** Allows later computations of the same owner to cancel this one. */
    void onReplace(Runnable cancel) {
      this.cancel = cancel;
    }
  }

  /**
   * Waits for a permit.
   *
   * @param replaces whether to cancel the owner's replaceable computations
   * @throws RequestException if no permit is available in time
   */
  Permit acquire(String owner, boolean replaces, Duration timeout) throws InterruptedException {
    long left = timeout.toNanos();
    lock.lockInterruptibly();
    try {
      if (waiting.stream().filter(owner::equals).count() >= MAX_WAITING) {
        throw RequestException.busy(
            "You have " + MAX_WAITING + " waiting requests already; repeat this one later.");
      }
      waiting.add(owner);
      try {
        while (taken.size() >= count || ofOwner(owner).size() >= Math.max(1, count / 2)) {
          if (replaces) {
            ofOwner(owner).stream().findFirst().ifPresent(oldest -> oldest.cancel.run());
          }
          if (left <= 0) {
            throw RequestException.busy(
                "The server is busy with "
                    + count
                    + " other computations, or with your share of them; repeat the"
                    + " request later.");
          }
          left = changed.awaitNanos(left);
        }
      } finally {
        waiting.remove(owner);
      }
      Permit permit = new Permit(owner);
      taken.add(permit);
      return permit;
    } finally {
      lock.unlock();
    }
  }

  void release(Permit permit) {
    lock.lock();
    try {
      taken.remove(permit);
      changed.signalAll();
    } finally {
      lock.unlock();
    }
  }

  private List<Permit> ofOwner(String owner) {
    return taken.stream().filter(p -> p.owner.equals(owner)).toList();
  }
}
