package org.sitaf.server.access.web;

import org.springframework.boot.diagnostics.AbstractFailureAnalyzer;
import org.springframework.boot.diagnostics.FailureAnalysis;

/** Reports the failure without a stack trace; registered in {@code META-INF/spring.factories}. */
final class InsecureTransportAnalyzer extends AbstractFailureAnalyzer<InsecureTransportException> {
  @Override
  protected FailureAnalysis analyze(Throwable root, InsecureTransportException cause) {
    return new FailureAnalysis(String.valueOf(cause.getMessage()), cause.remedy(), cause);
  }
}
