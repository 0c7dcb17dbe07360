package org.sitaf.server.storage;

import org.springframework.boot.diagnostics.AbstractFailureAnalyzer;
import org.springframework.boot.diagnostics.FailureAnalysis;

/** Says it without a stack trace; named in {@code META-INF/spring.factories}. */
final class NoRoomToStartAnalyzer extends AbstractFailureAnalyzer<NoRoomToStartException> {
  @Override
  protected FailureAnalysis analyze(Throwable root, NoRoomToStartException cause) {
    return new FailureAnalysis(String.valueOf(cause.getMessage()), cause.remedy(), cause);
  }
}
