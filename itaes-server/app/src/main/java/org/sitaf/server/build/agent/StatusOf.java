package org.sitaf.server.build.agent;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.access.enrolment.EnrolmentRefused;
import org.sitaf.server.build.OutdatedAttemptException;
import org.sitaf.server.build.log.BuildLogs;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.storage.StorageFailure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.dao.DataAccessException;
import org.springframework.transaction.TransactionException;

/** What an exception means to an agent, as the protocol has it. */
final class StatusOf {
  private static final Logger log = LoggerFactory.getLogger(StatusOf.class);

  private StatusOf() {}

  static StatusRuntimeException exception(RuntimeException e) {
    if (e instanceof StatusRuntimeException status) {
      return status;
    }
    return status(e)
        .withDescription(String.valueOf(e.getMessage()))
        .withCause(e)
        .asRuntimeException();
  }

  private static Status status(RuntimeException e) {
    if (e instanceof OutdatedAttemptException) {
      return Status.FAILED_PRECONDITION;
    }
    if (e instanceof BuildLogs.GapException) {
      return Status.OUT_OF_RANGE;
    }
    if (e instanceof InvalidInputException) {
      return Status.INVALID_ARGUMENT;
    }
    if (e instanceof EnrolmentRefused refused) {
      return refused.isNameTaken() ? Status.ALREADY_EXISTS : Status.UNAUTHENTICATED;
    }
    if (e instanceof Refusal refusal) {
      return switch (refusal.reason()) {
        case NOT_FOUND -> Status.NOT_FOUND;
        case MALFORMED, TOO_LARGE -> Status.INVALID_ARGUMENT;
        case CONFLICT, OUTDATED -> Status.FAILED_PRECONDITION;
        case QUOTA -> Status.RESOURCE_EXHAUSTED;
        case NO_ROOM, TOO_SLOW, BUSY -> Status.UNAVAILABLE;
      };
    }
    if (StorageFailure.of(e).isPresent()) {
      // Known and said elsewhere; agents call again and again until it is over.
      log.debug("A call of an agent has to wait", e);
      return Status.UNAVAILABLE;
    }
    log.error("A call of an agent failed", e);
    boolean passing = e instanceof DataAccessException || e instanceof TransactionException;
    return passing ? Status.UNAVAILABLE : Status.INTERNAL;
  }
}
