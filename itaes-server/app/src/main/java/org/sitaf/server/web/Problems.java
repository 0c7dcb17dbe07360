package org.sitaf.server.web;

import io.swagger.v3.oas.annotations.media.Schema;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.apache.tomcat.util.http.InvalidParameterException;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.beginning.node.SeveralNodesException;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.error.ComputationTimeoutException;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.storage.StorageFailure;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;
import org.springframework.dao.DataIntegrityViolationException;
import org.springframework.dao.OptimisticLockingFailureException;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.HttpStatusCode;
import org.springframework.http.MediaType;
import org.springframework.http.ProblemDetail;
import org.springframework.http.ResponseEntity;
import org.springframework.http.converter.HttpMessageNotReadableException;
import org.springframework.web.bind.MissingRequestHeaderException;
import org.springframework.web.bind.ServletRequestBindingException;
import org.springframework.web.bind.annotation.ExceptionHandler;
import org.springframework.web.bind.annotation.RestControllerAdvice;
import org.springframework.web.context.request.WebRequest;
import org.springframework.web.servlet.mvc.method.annotation.ResponseEntityExceptionHandler;

/** Converts exceptions to problem details (RFC 9457). */
@RestControllerAdvice
class Problems extends ResponseEntityExceptionHandler {
  private static final Logger log = LoggerFactory.getLogger(Problems.class);

  /** The schema of a problem in the OpenAPI document. */
  @Schema(name = "Problem", description = "RFC 9457 problem details")
  record ProblemView(
      @Nullable String type,
      String title,
      int status,
      @Nullable String detail,
      @Nullable String instance,
      @Schema(description = "the problems of an invalid input; absent for other errors")
          @Nullable List<DiagnosticView> diagnostics,
      @Schema(
              description =
                  "classes and programs of a ROS 2 package of which one must be chosen; absent for"
                      + " other errors")
          @Nullable List<String> nodes) {}

  @ExceptionHandler
  ResponseEntity<ProblemDetail> invalid(InvalidInputException e) {
    ProblemDetail problem = problem(HttpStatus.UNPROCESSABLE_CONTENT, "Invalid input", e);
    problem.setProperty("diagnostics", e.diagnostics().stream().map(DiagnosticView::of).toList());
    return response(problem);
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> ambiguous(SeveralNodesException e) {
    ProblemDetail problem = problem(HttpStatus.UNPROCESSABLE_CONTENT, "Several nodes", e);
    problem.setProperty("nodes", e.nodes());
    return response(problem);
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> rejected(RequestException e) {
    ProblemDetail problem =
        switch (e.reason()) {
          case UNAUTHENTICATED -> problem(HttpStatus.UNAUTHORIZED, "Not signed in", e);
          case FORBIDDEN -> problem(HttpStatus.FORBIDDEN, "Not allowed", e);
          case TOO_MANY_ATTEMPTS -> problem(HttpStatus.TOO_MANY_REQUESTS, "Too many attempts", e);
          case NOT_FOUND -> problem(HttpStatus.NOT_FOUND, "Not found", e);
          case MALFORMED -> problem(HttpStatus.BAD_REQUEST, "Invalid request", e);
          case CONFLICT -> problem(HttpStatus.CONFLICT, "Conflict", e);
          case OUTDATED -> problem(HttpStatus.PRECONDITION_FAILED, "Version outdated", e);
          case TOO_LARGE -> problem(HttpStatus.CONTENT_TOO_LARGE, "Too large", e);
          case DISK_FULL -> problem(HttpStatus.INSUFFICIENT_STORAGE, "Disk full", e);
          case QUOTA -> problem(HttpStatus.CONTENT_TOO_LARGE, "Quota exceeded", e);
          case TIMEOUT -> problem(HttpStatus.REQUEST_TIMEOUT, "Request timeout", e);
          case BUSY -> problem(HttpStatus.SERVICE_UNAVAILABLE, "Server busy", e);
        };
    return response(problem, e.retryAfter());
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> timedOut(ComputationTimeoutException e) {
    return response(problem(HttpStatus.UNPROCESSABLE_CONTENT, "Computation timed out", e));
  }

  /** Tomcat cannot decode the query string. */
  @ExceptionHandler
  ResponseEntity<ProblemDetail> unreadable(InvalidParameterException e) {
    return response(problem(HttpStatus.BAD_REQUEST, "Invalid request", e));
  }

  /** A value passed validation but violates a constraint of the database. */
  @ExceptionHandler
  ResponseEntity<ProblemDetail> unstorable(DataIntegrityViolationException e, WebRequest request) {
    log.warn("{}: {}", request.getDescription(false), e.getMessage());
    return response(
        problem(
            HttpStatus.BAD_REQUEST,
            "Invalid request",
            "The request cannot be stored: a name or a text is too long, or it refers to something"
                + " that was deleted."));
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> outdated(OptimisticLockingFailureException e) {
    return response(
        problem(
            HttpStatus.CONFLICT,
            "Conflict",
            "Another request changed the resource at the same time; repeat the request."));
  }

  /** The log contains the stack trace; the response does not reveal internals. */
  @ExceptionHandler
  @Nullable ResponseEntity<Object> failed(Exception e, WebRequest request) {
    Optional<StorageFailure> storageFailure = StorageFailure.of(e);
    if (storageFailure.isPresent()) {
      log.warn("{}: {}", request.getDescription(false), e.getMessage());
      return convert(response(problem(storageFailure.get())), request);
    }
    log.error("Request failed: {}", request.getDescription(false), e);
    ProblemDetail problem =
        ProblemDetail.forStatusAndDetail(
            HttpStatus.INTERNAL_SERVER_ERROR, "Internal server error; see the server's log.");
    return handleExceptionInternal(
        e, problem, new HttpHeaders(), HttpStatus.INTERNAL_SERVER_ERROR, request);
  }

  private static ProblemDetail problem(StorageFailure failure) {
    return switch (failure) {
      case DISK_FULL ->
          problem(
              HttpStatus.INSUFFICIENT_STORAGE,
              "Disk full",
              "The server's disk is full; nothing was changed. Repeat the request when there is"
                  + " free space; stored data can be read.");
      case DATABASE_UNAVAILABLE ->
          problem(
              HttpStatus.SERVICE_UNAVAILABLE,
              "Database unavailable",
              "The server cannot reach its database; repeat the request soon.");
    };
  }

  /** Requires If-Match, so that concurrent changes are not lost (RFC 6585, section 3). */
  @Override
  protected @Nullable ResponseEntity<Object> handleServletRequestBindingException(
      ServletRequestBindingException e,
      HttpHeaders headers,
      HttpStatusCode status,
      WebRequest request) {
    if (e instanceof MissingRequestHeaderException missing
        && missing.getHeaderName().equals(HttpHeaders.IF_MATCH)) {
      ProblemDetail problem =
          ProblemDetail.forStatusAndDetail(
              HttpStatus.PRECONDITION_REQUIRED,
              "Send If-Match with the version to which the change applies, such as \"3\", or with *"
                  + " for any version.");
      problem.setTitle("If-Match is missing");
      return createResponseEntity(problem, headers, HttpStatus.PRECONDITION_REQUIRED, request);
    }
    return super.handleServletRequestBindingException(e, headers, status, request);
  }

  /** The JSON reader wraps a {@link RequestException} that the body's stream throws. */
  @Override
  protected @Nullable ResponseEntity<Object> handleHttpMessageNotReadable(
      HttpMessageNotReadableException e,
      HttpHeaders headers,
      HttpStatusCode status,
      WebRequest request) {
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof RequestException rejected) {
        return convert(rejected(rejected), request);
      }
    }
    return super.handleHttpMessageNotReadable(e, headers, status, request);
  }

  private @Nullable ResponseEntity<Object> convert(
      ResponseEntity<ProblemDetail> response, WebRequest request) {
    return createResponseEntity(
        response.getBody(), response.getHeaders(), response.getStatusCode(), request);
  }

  @Override
  protected @Nullable ResponseEntity<Object> createResponseEntity(
      @Nullable Object body, HttpHeaders headers, HttpStatusCode status, WebRequest request) {
    HttpHeaders problemHeaders = new HttpHeaders();
    problemHeaders.putAll(headers);
    problemHeaders.setContentType(MediaType.APPLICATION_PROBLEM_JSON);
    return super.createResponseEntity(body, problemHeaders, status, request);
  }

  private static ProblemDetail problem(HttpStatus status, String title, RuntimeException e) {
    return problem(status, title, e.getMessage());
  }

  private static ProblemDetail problem(HttpStatus status, String title, @Nullable String detail) {
    ProblemDetail problem = ProblemDetail.forStatusAndDetail(status, detail);
    problem.setTitle(title);
    return problem;
  }

  private static ResponseEntity<ProblemDetail> response(ProblemDetail problem) {
    return response(problem, defaultRetryAfter(problem.getStatus()));
  }

  private static Optional<Duration> defaultRetryAfter(int status) {
    return switch (HttpStatus.valueOf(status)) {
      case INSUFFICIENT_STORAGE -> Optional.of(Duration.ofMinutes(1));
      case SERVICE_UNAVAILABLE -> Optional.of(Duration.ofSeconds(2));
      default -> Optional.empty();
    };
  }

  /** Always JSON: a client that accepts only XML still needs the error. */
  private static ResponseEntity<ProblemDetail> response(
      ProblemDetail problem, Optional<Duration> retryAfter) {
    ResponseEntity.BodyBuilder response =
        ResponseEntity.status(problem.getStatus()).contentType(MediaType.APPLICATION_PROBLEM_JSON);
    retryAfter.ifPresent(
        wait -> response.header(HttpHeaders.RETRY_AFTER, Long.toString(wait.toSeconds())));
    if (problem.getStatus() == HttpStatus.REQUEST_TIMEOUT.value()) {
      // Do not wait for the rest of the body.
      response.header(HttpHeaders.CONNECTION, "close");
    }
    return response.body(problem);
  }

  static List<Class<?>> views() {
    return List.of(ProblemView.class);
  }
}
