package org.sitaf.server.build.agent;

import java.time.Instant;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.springframework.data.jpa.repository.EntityGraph;
import org.springframework.data.jpa.repository.Modifying;
import org.springframework.data.jpa.repository.Query;
import org.springframework.data.repository.Repository;

interface KnownAgentRepository extends Repository<KnownAgent, String> {
  Optional<KnownAgent> findById(String name);

  /** Fetches the toolchains in the same query. */
  @EntityGraph(attributePaths = "toolchains")
  List<KnownAgent> findAllByOrderByName();

  @Query(
      "select a.name from KnownAgent a"
          + " where a.standing <> org.sitaf.server.build.agent.KnownAgent.Standing.ACTIVE")
  Set<String> findInactiveNames();

  @Modifying
  @Query("update KnownAgent a set a.lastSeen = :when, a.connected = true where a.name in :names")
  void saveSeen(Collection<String> names, Instant when);

  void delete(KnownAgent agent);

  KnownAgent save(KnownAgent agent);
}
