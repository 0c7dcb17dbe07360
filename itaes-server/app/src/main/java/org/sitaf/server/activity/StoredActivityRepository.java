package org.sitaf.server.activity;

import jakarta.persistence.LockModeType;
import java.util.List;
import java.util.Optional;
import java.util.Set;
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

  /**
   * Activities that have all tags.
   *
   * @param name all names if it is empty
   * @param text contained in the activities; may be empty
   * @param count of the tags
   */
  @Query(
      "select a from StoredActivity a where (:name = '' or a.name = :name)"
          + " and (locate(:text, lower(a.name)) > 0"
          + " or locate(:text, lower(a.description)) > 0"
          + " or locate(:text, lower(a.componentClass)) > 0)"
          + " and (select count(t) from StoredActivity o join o.tags t"
          + " where o.id = a.id and t in :tags) = :count")
  Page<StoredActivity> findTagged(
      String name, String text, Set<String> tags, long count, Pageable page);

  /** The tags in ascending order. */
  @Query(
      "select new org.sitaf.server.activity.Tags$Use(t, count(a))"
          + " from StoredActivity a join a.tags t group by t order by t")
  List<Tags.Use> findTags();

  StoredActivity saveAndFlush(StoredActivity activity);

  void delete(StoredActivity activity);
}
