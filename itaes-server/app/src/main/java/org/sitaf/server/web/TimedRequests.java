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
import org.sitaf.server.network.Addresses;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.LimitSettings;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.http.HttpHeaders;
import org.springframework.security.authentication.AnonymousAuthenticationToken;
import org.springframework.security.core.Authentication;
import org.springframework.security.core.context.SecurityContextHolder;
import org.springframework.stereotype.Component;
import org.springframework.web.filter.OncePerRequestFilter;

/** Gives the bodies of requests a deadline, and those that nobody reads too. */
@Component
@Order(Ordered.HIGHEST_PRECEDENCE + 1)
class TimedRequests extends OncePerRequestFilter {
  /** So much of a body that nobody wanted is read, for its sender to see the answer. */
  private static final long UNWANTED = 4 << 20;

  private static final Duration UNWANTED_WITHIN = Duration.ofSeconds(2);

  private final LimitSettings limits;
  private final BodyPlaces places;

  TimedRequests(LimitSettings limits, BodyPlaces places) {
    this.limits = limits;
    this.places = places;
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
        new TimedBody(request.getInputStream(), limits, places, () -> waiter(address));
    try {
      chain.doFilter(new Timed(request, timed), response);
      if (!request.isAsyncStarted() && !isReadToItsEnd(timed) && !response.isCommitted()) {
        response.setHeader(HttpHeaders.CONNECTION, "close");
      }
    } finally {
      timed.end();
    }
  }

  private static BodyPlaces.Waiter waiter(String address) {
    Authentication present = SecurityContextHolder.getContext().getAuthentication();
    boolean stranger = present == null || present instanceof AnonymousAuthenticationToken;
    return new BodyPlaces.Waiter(stranger ? address : present.getName(), stranger);
  }

  private static boolean isReadToItsEnd(TimedBody body) {
    long began = System.nanoTime();
    byte[] buffer = new byte[1 << 14];
    long left = UNWANTED;
    try {
      while (!body.isFinished()
          && left > 0
          && System.nanoTime() - began < UNWANTED_WITHIN.toNanos()) {
        int read = body.read(buffer, 0, buffer.length);
        if (read < 0) {
          return true;
        }
        left -= read;
      }
    } catch (Refusal e) {
      return false;
    }
    return body.isFinished();
  }

  private static final class Timed extends HttpServletRequestWrapper {
    private final TimedBody body;
    private @Nullable BufferedReader reader;

    Timed(HttpServletRequest request, TimedBody body) {
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
