package org.sitaf.server.schedule;

import java.util.Properties;
import org.sitaf.server.settings.Database;
import org.springframework.boot.quartz.autoconfigure.QuartzProperties;
import org.springframework.boot.quartz.autoconfigure.SchedulerFactoryBeanCustomizer;
import org.springframework.scheduling.quartz.SchedulerFactoryBean;
import org.springframework.stereotype.Component;

/**
 * Enables Quartz's clustering if several servers can share the database, so that each trigger fires
 * on one of them.
 */
@Component
class QuartzCluster implements SchedulerFactoryBeanCustomizer {
  private static final String CHECK_IN_MS = "4000";

  private final Database database;
  private final QuartzProperties quartz;

  QuartzCluster(Database database, QuartzProperties quartz) {
    this.database = database;
    this.quartz = quartz;
  }

  @Override
  public void customize(SchedulerFactoryBean scheduler) {
    if (database.isShared()) {
      Properties properties = new Properties();
      properties.putAll(quartz.getProperties());
      properties.setProperty("org.quartz.jobStore.isClustered", "true");
      properties.setProperty("org.quartz.jobStore.clusterCheckinInterval", CHECK_IN_MS);
      properties.setProperty("org.quartz.scheduler.instanceId", "AUTO");
      scheduler.setQuartzProperties(properties);
    }
  }
}
