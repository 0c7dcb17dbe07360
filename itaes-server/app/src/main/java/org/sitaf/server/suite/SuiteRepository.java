package org.sitaf.server.suite;

import java.time.Instant;
import java.util.Optional;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface SuiteRepository extends Repository<StoredSuite, String> {
  Optional<StoredSuite> findById(String id);

  /** The version of a suite, without loading its document. */
  @Query("select s.version from StoredSuite s where s.id = :id")
  Optional<Long> versionOf(String id);

  /** The newest suite of a model that is older than the given time. */
  Optional<StoredSuite> findFirstByActivityIdAndModelAndCreatedBeforeOrderByCreatedDesc(
      String activityId, String model, Instant created);

  Page<StoredSuite> findByActivityId(String activityId, Pageable page);

  StoredSuite saveAndFlush(StoredSuite suite);
}
