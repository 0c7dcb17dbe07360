package org.sitaf.server.web;

import io.swagger.v3.oas.annotations.media.Schema;
import java.util.List;
import java.util.Optional;
import org.apache.tomcat.util.http.InvalidParameterException;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.refusal.OvertimeException;
import org.sitaf.server.refusal.Refusal;
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

/**
 * Errors as problem details (RFC 9457); what is wrong with an input stands in {@code diagnostics}.
 */
@RestControllerAdvice
class Problems extends ResponseEntityExceptionHandler {
  private static final Logger log = LoggerFactory.getLogger(Problems.class);

  /** What a problem looks like, for the OpenAPI document. */
  @Schema(name = "Problem", description = "RFC 9457 problem details")
  record ProblemView(
      @Nullable String type,
      String title,
      int status,
      @Nullable String detail,
      @Nullable String instance,
      @Schema(description = "what is wrong with the input; absent where that is not the matter")
          @Nullable List<DiagnosticView> diagnostics) {}

  @ExceptionHandler
  ResponseEntity<ProblemDetail> invalid(InvalidInputException e) {
    ProblemDetail problem =
        problem(HttpStatus.UNPROCESSABLE_CONTENT, "The input cannot be used", e);
    problem.setProperty("diagnostics", e.diagnostics().stream().map(DiagnosticView::of).toList());
    return answer(problem);
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> refused(Refusal e) {
    return answer(
        switch (e.reason()) {
          case NOT_FOUND -> problem(HttpStatus.NOT_FOUND, "Not found", e);
          case MALFORMED -> problem(HttpStatus.BAD_REQUEST, "The request is wrong", e);
          case CONFLICT -> problem(HttpStatus.CONFLICT, "Not possible at present", e);
          case OUTDATED -> problem(HttpStatus.PRECONDITION_FAILED, "Changed meanwhile", e);
          case TOO_LARGE -> problem(HttpStatus.CONTENT_TOO_LARGE, "Too large", e);
          case NO_ROOM -> problem(HttpStatus.INSUFFICIENT_STORAGE, "No room", e);
          case QUOTA -> problem(HttpStatus.CONTENT_TOO_LARGE, "Quota used up", e);
          case TOO_SLOW -> problem(HttpStatus.REQUEST_TIMEOUT, "Too slow", e);
          case BUSY -> problem(HttpStatus.SERVICE_UNAVAILABLE, "Busy", e);
        });
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> overtime(OvertimeException e) {
    return answer(problem(HttpStatus.UNPROCESSABLE_CONTENT, "The input takes too long", e));
  }

  /** A query or form that cannot be read. */
  @ExceptionHandler
  ResponseEntity<ProblemDetail> unreadable(InvalidParameterException e) {
    return answer(problem(HttpStatus.BAD_REQUEST, "The request is wrong", e));
  }

  /** What the readers let pass and no column holds. */
  @ExceptionHandler
  ResponseEntity<ProblemDetail> unstorable(DataIntegrityViolationException e, WebRequest request) {
    log.warn("{}: {}", request.getDescription(false), e.getMessage());
    ProblemDetail problem =
        ProblemDetail.forStatusAndDetail(
            HttpStatus.BAD_REQUEST,
            "Something in the request cannot be stored: a name or a text is too long, or it refers to what is gone.");
    problem.setTitle("The request is wrong");
    return answer(problem);
  }

  @ExceptionHandler
  ResponseEntity<ProblemDetail> outdated(OptimisticLockingFailureException e) {
    ProblemDetail problem =
        ProblemDetail.forStatusAndDetail(
            HttpStatus.CONFLICT,
            "Somebody else changed it at the same moment; repeat the request.");
    problem.setTitle("Changed meanwhile");
    return answer(problem);
  }

  /** What nobody foresaw: the log has it all, the answer nothing of the inside. */
  @ExceptionHandler
  @Nullable ResponseEntity<Object> failed(Exception e, WebRequest request) {
    Optional<StorageFailure> passing = StorageFailure.of(e);
    if (passing.isPresent()) {
      log.warn("{}: {}", request.getDescription(false), e.getMessage());
      ResponseEntity<ProblemDetail> answer = answer(problem(passing.get()));
      return createResponseEntity(
          answer.getBody(), answer.getHeaders(), answer.getStatusCode(), request);
    }
    log.error("A request failed: {}", request.getDescription(false), e);
    ProblemDetail problem =
        ProblemDetail.forStatusAndDetail(
            HttpStatus.INTERNAL_SERVER_ERROR, "The server failed; its log says why.");
    return handleExceptionInternal(
        e, problem, new HttpHeaders(), HttpStatus.INTERNAL_SERVER_ERROR, request);
  }

  private static ProblemDetail problem(StorageFailure passing) {
    ProblemDetail problem =
        switch (passing) {
          case NO_ROOM ->
              ProblemDetail.forStatusAndDetail(
                  HttpStatus.INSUFFICIENT_STORAGE,
                  "The server's disk is full, so nothing was changed. Repeat the request when there"
                      + " is room on it; what is stored can be read.");
          case DATABASE_AWAY ->
              ProblemDetail.forStatusAndDetail(
                  HttpStatus.SERVICE_UNAVAILABLE,
                  "The server's database cannot be reached at present; repeat the request soon.");
        };
    problem.setTitle(passing == StorageFailure.NO_ROOM ? "No room" : "Not available");
    return problem;
  }

  /** Without If-Match a change could undo one of another person unnoticed (RFC 6585, section 3). */
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
              "Send If-Match with the version that the change is made to, such as \"3\", or with *"
                  + " to change any version.");
      problem.setTitle("If-Match is missing");
      return createResponseEntity(problem, headers, HttpStatus.PRECONDITION_REQUIRED, request);
    }
    return super.handleServletRequestBindingException(e, headers, status, request);
  }

  /** A refusal while a body was read comes wrapped by the reader. */
  @Override
  protected @Nullable ResponseEntity<Object> handleHttpMessageNotReadable(
      HttpMessageNotReadableException e,
      HttpHeaders headers,
      HttpStatusCode status,
      WebRequest request) {
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof Refusal refusal) {
        ResponseEntity<ProblemDetail> answer = refused(refusal);
        return createResponseEntity(
            answer.getBody(), answer.getHeaders(), answer.getStatusCode(), request);
      }
    }
    return super.handleHttpMessageNotReadable(e, headers, status, request);
  }

  @Override
  protected @Nullable ResponseEntity<Object> createResponseEntity(
      @Nullable Object body, HttpHeaders headers, HttpStatusCode status, WebRequest request) {
    HttpHeaders own = new HttpHeaders();
    own.putAll(headers);
    own.setContentType(MediaType.APPLICATION_PROBLEM_JSON);
    return super.createResponseEntity(body, own, status, request);
  }

  private static ProblemDetail problem(HttpStatus status, String title, RuntimeException e) {
    ProblemDetail problem = ProblemDetail.forStatusAndDetail(status, e.getMessage());
    problem.setTitle(title);
    return problem;
  }

  /**
   * As JSON whatever the client asked for: a client that wants XML still has to learn what is
   * wrong.
   */
  private static ResponseEntity<ProblemDetail> answer(ProblemDetail problem) {
    ResponseEntity.BodyBuilder answer =
        ResponseEntity.status(problem.getStatus()).contentType(MediaType.APPLICATION_PROBLEM_JSON);
    if (problem.getStatus() == HttpStatus.INSUFFICIENT_STORAGE.value()) {
      answer.header(HttpHeaders.RETRY_AFTER, "60");
    } else if (problem.getStatus() == HttpStatus.SERVICE_UNAVAILABLE.value()) {
      answer.header(HttpHeaders.RETRY_AFTER, Integer.toString(Refusal.retryAfterSeconds()));
    } else if (problem.getStatus() == HttpStatus.REQUEST_TIMEOUT.value()) {
      // What is left of the body is not waited for.
      answer.header(HttpHeaders.CONNECTION, "close");
    }
    return answer.body(problem);
  }

  static List<Class<?>> views() {
    return List.of(ProblemView.class);
  }
}
