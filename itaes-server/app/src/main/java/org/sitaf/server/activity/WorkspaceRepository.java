package org.sitaf.server.activity;

import jakarta.persistence.LockModeType;
import java.util.Optional;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.jpa.repository.Lock;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface WorkspaceRepository extends Repository<Workspace, String> {
  Optional<Workspace> findById(String id);

  /** With the row locked: changes of one activity come one after the other. */
  @Lock(LockModeType.PESSIMISTIC_WRITE)
  @Query("select w from Workspace w where w.id = :id")
  Optional<Workspace> findForChange(String id);

  Page<Workspace> findAll(Pageable page);

  Page<Workspace> findByName(String name, Pageable page);

  Workspace saveAndFlush(Workspace workspace);

  void delete(Workspace workspace);
}
