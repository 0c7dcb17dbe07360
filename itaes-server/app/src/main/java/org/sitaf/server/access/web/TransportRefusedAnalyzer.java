package org.sitaf.server.access.web;

import org.springframework.boot.diagnostics.AbstractFailureAnalyzer;
import org.springframework.boot.diagnostics.FailureAnalysis;

/** Says it without a stack trace; named in {@code META-INF/spring.factories}. */
final class TransportRefusedAnalyzer extends AbstractFailureAnalyzer<TransportRefusedException> {
  @Override
  protected FailureAnalysis analyze(Throwable root, TransportRefusedException cause) {
    return new FailureAnalysis(String.valueOf(cause.getMessage()), cause.remedy(), cause);
  }
}
