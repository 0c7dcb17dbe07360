package org.sitaf.server.suite;

import java.util.Optional;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.repository.Repository;

interface SuiteRepository extends Repository<StoredSuite, String> {
  Optional<StoredSuite> findById(String id);

  Page<StoredSuite> findByActivityId(String activityId, Pageable page);

  StoredSuite saveAndFlush(StoredSuite suite);
}
