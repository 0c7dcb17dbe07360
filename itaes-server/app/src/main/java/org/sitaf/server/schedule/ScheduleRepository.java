package org.sitaf.server.schedule;

import java.util.List;
import java.util.Optional;
import org.springframework.data.domain.Page;
import org.springframework.data.domain.Pageable;
import org.springframework.data.repository.Repository;

interface ScheduleRepository extends Repository<Schedule, String> {
  Optional<Schedule> findById(String id);

  Page<Schedule> findAll(Pageable page);

  Page<Schedule> findByActivityId(String activityId, Pageable page);

  List<Schedule> findByLeaveOutContaining(String name);

  Schedule save(Schedule schedule);

  void delete(Schedule schedule);
}
