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

/** Keeps the server readable when its disk is full. */
@Configuration(proxyBeanMethods = false)
class StorageConfiguration {
  private static final Logger log = LoggerFactory.getLogger(StorageConfiguration.class);

  /** Applies to H2 files only; a database server handles its disk itself. */
  @Bean
  static BeanPostProcessor diskFullProtection(
      ObjectProvider<DiskSpace> disks,
      ObjectProvider<DiskReserve> reserves,
      Environment environment) {
    return new BeanPostProcessor() {
      @Override
      public Object postProcessAfterInitialization(Object bean, String name) {
        return bean instanceof HikariDataSource pool && GuardedDataSource.guards(environment)
            ? new GuardedDataSource(
                pool,
                disks.getObject()::whyTheDatabaseIsNotWritten,
                reserves.getObject()::giveBackIfNeeded)
            : bean;
      }
    };
  }

  /** Requests that only read succeed although the session's last access time cannot be stored. */
  @Bean(defaultCandidate = false)
  TransactionOperations springSessionTransactionOperations(
      PlatformTransactionManager manager, DiskSpace disk) {
    TransactionTemplate transaction = new TransactionTemplate(manager);
    transaction.setPropagationBehavior(TransactionDefinition.PROPAGATION_REQUIRES_NEW);
    return new TransactionOperations() {
      @Override
      public <T> T execute(TransactionCallback<T> action) {
        try {
          return transaction.execute(action);
        } catch (RuntimeException e) {
          // H2 also writes to roll back, and closes the database if it cannot.
          boolean isExpected =
              StorageFailure.of(e)
                  .filter(failure -> failure == StorageFailure.DISK_FULL || !disk.canWrite())
                  .isPresent();
          if (!isExpected) {
            throw e;
          }
          log.debug("The session's last access time was not stored: the disk is full", e);
          return null;
        }
      }
    };
  }
}
