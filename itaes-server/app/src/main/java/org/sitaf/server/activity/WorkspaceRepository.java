package org.sitaf.server.activity;

import java.util.Optional;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.repository.Repository;

interface WorkspaceRepository extends Repository<Workspace, String> {
  Optional<Workspace> findById(String id);

  Page<Workspace> findAll(Pageable page);

  Page<Workspace> findByName(String name, Pageable page);

  Workspace saveAndFlush(Workspace workspace);

  void delete(Workspace workspace);
}
