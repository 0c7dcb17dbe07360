package org.sitaf.server.access;

import java.time.Duration;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.ProblemDetail;
import org.springframework.web.ErrorResponseException;

/** A request is refused because of who makes it. */
public final class Denial {
  private Denial() {}

  /** Nobody is known by what was given. */
  public static ErrorResponseException unknown(String detail) {
    return of(HttpStatus.UNAUTHORIZED, "Not signed in", detail);
  }

  /** The caller is known, and may not. */
  public static ErrorResponseException forbidden(String detail) {
    return of(HttpStatus.FORBIDDEN, "Not allowed", detail);
  }

  /** Tried too often. */
  public static ErrorResponseException tooOften(Duration wait) {
    long seconds = Math.max(1, wait.toSeconds());
    ErrorResponseException denial =
        of(
            HttpStatus.TOO_MANY_REQUESTS,
            "Too many attempts",
            "Too many attempts to sign in; try again in " + seconds + " s.");
    denial.getHeaders().set(HttpHeaders.RETRY_AFTER, Long.toString(seconds));
    return denial;
  }

  private static ErrorResponseException of(HttpStatus status, String title, String detail) {
    ProblemDetail problem = ProblemDetail.forStatusAndDetail(status, detail);
    problem.setTitle(title);
    return new ErrorResponseException(status, problem, null);
  }
}
