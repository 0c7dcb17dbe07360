package org.sitaf.server.schedule;

import java.util.Properties;
import org.sitaf.server.settings.Database;
import org.springframework.boot.quartz.autoconfigure.QuartzProperties;
import org.springframework.boot.quartz.autoconfigure.SchedulerFactoryBeanCustomizer;
import org.springframework.scheduling.quartz.SchedulerFactoryBean;
import org.springframework.stereotype.Component;

/**
 * With a database that several servers share, Quartz fires each time on one of them, and what a
 * server that died left is taken over by another.
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
