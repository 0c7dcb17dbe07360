package org.sitaf.server.access.web;

import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.audit.Audit;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Component;

/** Drops what the audit log need not keep any longer. */
@Component
class Retention {
  private final Audit audit;
  private final AccessSettings settings;

  Retention(Audit audit, AccessSettings settings) {
    this.audit = audit;
    this.settings = settings;
  }

  @Scheduled(initialDelayString = "PT1M", fixedDelayString = "P1D")
  void forget() {
    audit.forget(settings.auditRetention());
  }
}
