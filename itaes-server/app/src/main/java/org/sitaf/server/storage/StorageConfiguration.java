package org.sitaf.server.storage;

import com.zaxxer.hikari.HikariDataSource;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.beans.factory.ObjectProvider;
import org.springframework.beans.factory.config.BeanPostProcessor;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.core.env.Environment;
import org.springframework.transaction.PlatformTransactionManager;
import org.springframework.transaction.TransactionDefinition;
import org.springframework.transaction.support.TransactionCallback;
import org.springframework.transaction.support.TransactionOperations;
import org.springframework.transaction.support.TransactionTemplate;

/** Has the server bear a full disk. */
@Configuration(proxyBeanMethods = false)
class StorageConfiguration {
  private static final Logger log = LoggerFactory.getLogger(StorageConfiguration.class);

  /** A database server looks after its disk itself; a file on ours is ours to look after. */
  @Bean
  static BeanPostProcessor guardOfTheDatabase(
      ObjectProvider<DiskSpace> disks, Environment environment) {
    return new BeanPostProcessor() {
      @Override
      public Object postProcessAfterInitialization(Object bean, String name) {
        return bean instanceof HikariDataSource pool && GuardedDataSource.guards(environment)
            ? new GuardedDataSource(pool, disks.getObject()::whyTheDatabaseIsNotWritten)
            : bean;
      }
    };
  }

  /** A request that only looks is answered, though it cannot be noted when it was. */
  @Bean(defaultCandidate = false)
  TransactionOperations springSessionTransactionOperations(PlatformTransactionManager manager) {
    TransactionTemplate transaction = new TransactionTemplate(manager);
    transaction.setPropagationBehavior(TransactionDefinition.PROPAGATION_REQUIRES_NEW);
    return new TransactionOperations() {
      @Override
      public <T> T execute(TransactionCallback<T> action) {
        try {
          return transaction.execute(action);
        } catch (RuntimeException e) {
          if (StorageFailure.of(e).filter(StorageFailure.NO_ROOM::equals).isEmpty()) {
            throw e;
          }
          log.debug("The use of a session is not noted: the disk is full", e);
          return null;
        }
      }
    };
  }
}
