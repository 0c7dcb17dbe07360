package org.sitaf.server.build;

import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.springframework.data.jpa.repository.Modifying;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface AttemptRepository extends Repository<Attempt, Long> {
  Optional<Attempt> findById(long token);

  Optional<Attempt> findByBuildIdAndNo(String buildId, int no);

  List<Attempt> findByBuildIdOrderByNo(String buildId);

  Attempt saveAndFlush(Attempt attempt);

  @Query(
      "select new org.sitaf.server.build.AttemptKey(a.buildId, a.no, a.token)"
          + " from Attempt a where a.finished is null and a.leaseUntil < :now")
  List<AttemptKey> findOverdue(Instant now);

  @Query("select min(a.leaseUntil) from Attempt a where a.finished is null")
  Optional<Instant> findNextDeadline();

  @Query(
      "select a.token from Attempt a"
          + " where a.finished is null and a.agent = :agent and a.token in :tokens")
  List<Long> findRunning(String agent, Collection<Long> tokens);

  @Query(
      "select new org.sitaf.server.build.AttemptKey(a.buildId, a.no, a.token)"
          + " from Attempt a where a.finished is null and a.agent = :agent order by a.token")
  List<AttemptKey> findRunningOf(String agent);

  @Query("select a.token from Attempt a where a.finished is not null and a.token in :tokens")
  List<Long> findEnded(Collection<Long> tokens);

  @Modifying
  @Query(
      "update Attempt a set a.leaseUntil = :until where a.finished is null and a.token in :tokens")
  void renew(Collection<Long> tokens, Instant until);

  @Modifying
  @Query("update Attempt a set a.leaseUntil = :until where a.finished is null")
  int renewAll(Instant until);
}
