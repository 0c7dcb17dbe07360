package org.sitaf.server.storage;

import org.springframework.boot.diagnostics.AbstractFailureAnalyzer;
import org.springframework.boot.diagnostics.FailureAnalysis;

/** Reports the failure without a stack trace; registered in {@code META-INF/spring.factories}. */
final class DiskFullAtStartAnalyzer extends AbstractFailureAnalyzer<DiskFullAtStartException> {
  @Override
  protected FailureAnalysis analyze(Throwable root, DiskFullAtStartException cause) {
    return new FailureAnalysis(String.valueOf(cause.getMessage()), cause.remedy(), cause);
  }
}
