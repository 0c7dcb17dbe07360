package org.sitaf.server.build;

import jakarta.persistence.Column;
import jakarta.persistence.Embeddable;
import java.util.BitSet;
import java.util.Collection;
import java.util.Set;
import java.util.stream.Collectors;

/** The number of cases, and which of them have finished in the current attempt. */
@Embeddable
class CaseProgress {
  @Column(name = "cases_total")
  private int total;

  private int lastCase;

  @Column(name = "cases_seen")
  private byte[] seen;

  @Column(name = "cases_done")
  private int done;

  /** For the persistence provider. */
  protected CaseProgress() {
    seen = new byte[0];
  }

  /**
   * Creates the progress of an attempt that has not started.
   *
   * @param lastCase the highest number of a case
   */
  CaseProgress(int total, int lastCase) {
    this();
    this.total = total;
    this.lastCase = lastCase;
  }

  /** Resets the progress for another attempt. */
  void restart() {
    seen = new byte[0];
    done = 0;
  }

  /**
   * Adds finished cases; numbers of unknown cases are ignored.
   *
   * @return those that were not added before
   */
  Set<Integer> add(Collection<Integer> numbers) {
    BitSet finished = BitSet.valueOf(seen);
    Set<Integer> added =
        numbers.stream()
            .filter(no -> no >= 1 && no <= lastCase && !finished.get(no))
            .collect(Collectors.toUnmodifiableSet());
    added.forEach(finished::set);
    seen = finished.toByteArray();
    done = Math.min(finished.cardinality(), total);
    return added;
  }

  /** Sets the number of finished cases. */
  void set(int finished) {
    done = finished;
  }

  int total() {
    return total;
  }

  int done() {
    return done;
  }
}
