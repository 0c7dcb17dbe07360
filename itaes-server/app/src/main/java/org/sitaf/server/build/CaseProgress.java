package org.sitaf.server.build;

import jakarta.persistence.Column;
import jakarta.persistence.Embeddable;
import java.util.BitSet;
import java.util.Collection;
import java.util.Set;
import java.util.stream.Collectors;

/** How many cases there are, and which of them have ended in the attempt under way. */
@Embeddable
class CaseProgress {
  @Column(name = "cases_total")
  private int total;

  private int lastCase;

  @Column(name = "cases_seen")
  private byte[] seen;

  @Column(name = "cases_done")
  private int done;

  /** Of no cases; for the persistence provider. */
  protected CaseProgress() {
    seen = new byte[0];
  }

  /**
   * None has ended.
   *
   * @param lastCase the highest number of a case
   */
  CaseProgress(int total, int lastCase) {
    this();
    this.total = total;
    this.lastCase = lastCase;
  }

  /** Another attempt begins with the first case. */
  void restart() {
    seen = new byte[0];
    done = 0;
  }

  /**
   * Notes cases that have ended; one that was noted before, or that there is not, does not count.
   *
   * @return those that were not noted before
   */
  Set<Integer> note(Collection<Integer> numbers) {
    BitSet noted = BitSet.valueOf(seen);
    Set<Integer> news =
        numbers.stream()
            .filter(no -> no >= 1 && no <= lastCase && !noted.get(no))
            .collect(Collectors.toUnmodifiableSet());
    news.forEach(noted::set);
    seen = noted.toByteArray();
    done = Math.min(noted.cardinality(), total);
    return news;
  }

  /** It is known by other means how many have ended. */
  void set(int ended) {
    done = ended;
  }

  int total() {
    return total;
  }

  int done() {
    return done;
  }
}
