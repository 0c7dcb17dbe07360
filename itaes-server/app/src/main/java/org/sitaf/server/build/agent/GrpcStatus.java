package org.sitaf.server.build.agent;

import io.grpc.Status;
import io.grpc.StatusRuntimeException;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.access.enrolment.EnrolmentException;
import org.sitaf.server.build.OutdatedAttemptException;
import org.sitaf.server.build.log.BuildLogs;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.storage.StorageFailure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.dao.DataAccessException;
import org.springframework.transaction.TransactionException;

/** Converts exceptions to gRPC status codes. */
final class GrpcStatus {
  private static final Logger log = LoggerFactory.getLogger(GrpcStatus.class);

  private GrpcStatus() {}

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
    if (e instanceof EnrolmentException enrolment) {
      return enrolment.isNameTaken() ? Status.ALREADY_EXISTS : Status.UNAUTHENTICATED;
    }
    if (e instanceof RequestException rejected) {
      return switch (rejected.reason()) {
        case UNAUTHENTICATED -> Status.UNAUTHENTICATED;
        case FORBIDDEN -> Status.PERMISSION_DENIED;
        case NOT_FOUND -> Status.NOT_FOUND;
        case MALFORMED, TOO_LARGE -> Status.INVALID_ARGUMENT;
        case CONFLICT, OUTDATED -> Status.FAILED_PRECONDITION;
        case QUOTA, TOO_MANY_ATTEMPTS -> Status.RESOURCE_EXHAUSTED;
        case DISK_FULL, TIMEOUT, BUSY -> Status.UNAVAILABLE;
      };
    }
    if (StorageFailure.of(e).isPresent()) {
      // Logged elsewhere; agents retry until the failure is over.
      log.debug("Call of an agent failed temporarily", e);
      return Status.UNAVAILABLE;
    }
    log.error("Call of an agent failed", e);
    boolean temporary = e instanceof DataAccessException || e instanceof TransactionException;
    return temporary ? Status.UNAVAILABLE : Status.INTERNAL;
  }
}
