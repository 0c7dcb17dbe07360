package org.sitaf.server.access.web;

import org.sitaf.server.access.AccessSettings;
import org.sitaf.server.audit.Audit;
import org.springframework.scheduling.annotation.Scheduled;
import org.springframework.stereotype.Component;

/** Deletes old events from the audit log once a day. */
@Component
class AuditRetention {
  private final Audit audit;
  private final AccessSettings settings;

  AuditRetention(Audit audit, AccessSettings settings) {
    this.audit = audit;
    this.settings = settings;
  }

  @Scheduled(initialDelayString = "PT1M", fixedDelayString = "P1D")
  void deleteOld() {
    audit.deleteOlderThan(settings.auditRetention());
  }
}
