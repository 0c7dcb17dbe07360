package org.sitaf.server.build.agent;

import java.util.List;
import java.util.Optional;
import org.springframework.data.repository.Repository;

interface KnownAgentRepository extends Repository<KnownAgent, String> {
  Optional<KnownAgent> findById(String name);

  List<KnownAgent> findAllByOrderByName();

  KnownAgent save(KnownAgent agent);
}
