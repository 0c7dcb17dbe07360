package org.sitaf.server.build;

import jakarta.persistence.LockModeType;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import org.springframework.data.jpa.repository.JpaSpecificationExecutor;
import org.springframework.data.jpa.repository.Lock;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface BuildRepository extends Repository<Build, String>, JpaSpecificationExecutor<Build> {
  Optional<Build> findById(String id);

  /** Locks the row, so that changes of a build are serialized. */
  @Lock(LockModeType.PESSIMISTIC_WRITE)
  @Query("select b from Build b where b.id = :id")
  Optional<Build> findForUpdate(String id);

  List<Build> findByActivityId(String activityId);

  Optional<Build> findFirstByAnalysedIdAndKindOrderByCreatedDescIdDesc(
      String analysedId, BuildKind kind);

  List<Build> findByParentIdOrderByShard(String parentId);

  @Query(
      "select b.id from Build b where b.shards > 0 and b.state in"
          + " (org.sitaf.server.build.BuildState.QUEUED,"
          + " org.sitaf.server.build.BuildState.RUNNING)")
  List<String> findUnfinishedWithShards();

  /** Builds that are over although some of their shards are not. */
  @Query(
      "select distinct b.id from Build b, Build p where p.parentId = b.id and p.finished is null"
          + " and b.finished is not null")
  List<String> findEndedWithUnfinishedShards();

  @Query("select b.id from Build b where b.scheduleId = :scheduleId and b.fireTime = :fireTime")
  Optional<String> findIdByReservation(String scheduleId, Instant fireTime);

  Build saveAndFlush(Build build);
}
