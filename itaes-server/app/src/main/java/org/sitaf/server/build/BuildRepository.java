package org.sitaf.server.build;

import jakarta.persistence.LockModeType;
import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import org.springframework.data.domain.Limit;
import org.springframework.data.jpa.repository.JpaSpecificationExecutor;
import org.springframework.data.jpa.repository.Lock;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface BuildRepository extends Repository<Build, String>, JpaSpecificationExecutor<Build> {
  Optional<Build> findById(String id);

  /** With the row locked: changes of one build come one after the other. */
  @Lock(LockModeType.PESSIMISTIC_WRITE)
  @Query("select b from Build b where b.id = :id")
  Optional<Build> findForChange(String id);

  @Query(
      "select b.id from Build b where b.state = org.sitaf.server.build.BuildState.QUEUED"
          + " and b.language in :languages order by b.created, b.id")
  List<String> findQueued(Collection<String> languages, Limit limit);

  List<Build> findByActivityId(String activityId);

  boolean existsByScheduleIdAndFireTime(String scheduleId, Instant fireTime);

  Build saveAndFlush(Build build);
}
