package org.sitaf.server.activity;

import jakarta.persistence.LockModeType;
import java.util.Optional;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.jpa.repository.Lock;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface StoredActivityRepository extends Repository<StoredActivity, String> {
  Optional<StoredActivity> findById(String id);

  /** Locks the row, so that changes of an activity are serialized. */
  @Lock(LockModeType.PESSIMISTIC_WRITE)
  @Query("select a from StoredActivity a where a.id = :id")
  Optional<StoredActivity> findForUpdate(String id);

  Page<StoredActivity> findAll(Pageable page);

  Page<StoredActivity> findByName(String name, Pageable page);

  /** With locate, no character of the searched text is a wildcard. */
  @Query(
      "select a from StoredActivity a where locate(:text, lower(a.name)) > 0"
          + " or locate(:text, lower(a.description)) > 0"
          + " or locate(:text, lower(a.componentClass)) > 0")
  Page<StoredActivity> findContaining(String text, Pageable page);

  StoredActivity saveAndFlush(StoredActivity activity);

  void delete(StoredActivity activity);
}
