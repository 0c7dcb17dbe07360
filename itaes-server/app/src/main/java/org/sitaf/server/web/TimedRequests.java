package org.sitaf.server.web;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletInputStream;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.network.Addresses;
import org.sitaf.server.settings.LimitSettings;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.http.HttpHeaders;
import org.springframework.security.authentication.AnonymousAuthenticationToken;
import org.springframework.security.core.Authentication;
import org.springframework.security.core.context.SecurityContextHolder;
import org.springframework.stereotype.Component;
import org.springframework.web.filter.OncePerRequestFilter;

/** Sets deadlines for request bodies, including those that no handler reads. */
@Component
@Order(Ordered.HIGHEST_PRECEDENCE + 1)
class TimedRequests extends OncePerRequestFilter {
  /**
   * Bytes of an unread body that are drained after the handler has ended. Some clients only read
   * the response after they have sent the whole body.
   */
  private static final long MAX_DRAINED = 4 << 20;

  private static final Duration DRAIN_TIMEOUT = Duration.ofSeconds(2);

  private final LimitSettings limits;
  private final BodyPermits permits;

  TimedRequests(LimitSettings limits, BodyPermits permits) {
    this.limits = limits;
    this.permits = permits;
  }

  @Override
  protected void doFilterInternal(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws ServletException, IOException {
    boolean body =
        request.getContentLengthLong() > 0
            || request.getHeader(HttpHeaders.TRANSFER_ENCODING) != null;
    if (!body) {
      chain.doFilter(request, response);
      return;
    }
    String address = Addresses.group(request.getRemoteAddr());
    TimedBody timed =
        new TimedBody(request.getInputStream(), limits, permits, () -> client(address));
    try {
      chain.doFilter(new TimedRequest(request, timed), response);
      if (!request.isAsyncStarted() && !drain(timed) && !response.isCommitted()) {
        response.setHeader(HttpHeaders.CONNECTION, "close");
      }
    } finally {
      timed.end();
    }
  }

  private static BodyPermits.Client client(String address) {
    Authentication caller = SecurityContextHolder.getContext().getAuthentication();
    boolean anonymous = caller == null || caller instanceof AnonymousAuthenticationToken;
    return new BodyPermits.Client(anonymous ? address : caller.getName(), anonymous);
  }

  /** Reads the rest of a body; returns whether its end was reached. */
  private static boolean drain(TimedBody body) {
    long startNanos = System.nanoTime();
    byte[] buffer = new byte[1 << 14];
    long left = MAX_DRAINED;
    try {
      while (!body.isFinished()
          && left > 0
          && System.nanoTime() - startNanos < DRAIN_TIMEOUT.toNanos()) {
        int read = body.read(buffer, 0, buffer.length);
        if (read < 0) {
          return true;
        }
        left -= read;
      }
    } catch (RequestException e) {
      return false;
    }
    return body.isFinished();
  }

  private static final class TimedRequest extends HttpServletRequestWrapper {
    private final TimedBody body;
    private @Nullable BufferedReader reader;

    TimedRequest(HttpServletRequest request, TimedBody body) {
      super(request);
      this.body = body;
    }

    @Override
    public ServletInputStream getInputStream() {
      return body;
    }

    @Override
    public BufferedReader getReader() throws IOException {
      if (reader == null) {
        String named = getCharacterEncoding();
        String charset = named == null ? StandardCharsets.UTF_8.name() : named;
        reader = new BufferedReader(new InputStreamReader(body, charset));
      }
      return reader;
    }
  }
}
