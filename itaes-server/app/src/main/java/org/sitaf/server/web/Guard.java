package org.sitaf.server.web;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.http.HttpHeaders;
import org.springframework.http.HttpStatus;
import org.springframework.http.MediaType;
import org.springframework.stereotype.Component;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * The server executes code for whoever can reach it. A page of another site in the browser of
 * somebody who can must not: requests under a foreign host name (DNS rebinding) or from a foreign
 * origin are refused, and no answer may run anything but the portal's own scripts.
 */
@Component
@Order(Ordered.HIGHEST_PRECEDENCE)
class Guard extends OncePerRequestFilter {
  private static final Set<String> LOOPBACK = Set.of("localhost", "127.0.0.1", "[::1]");
  private static final String PORTAL_POLICY =
      "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data:;"
          + " font-src 'self' data:; connect-src 'self'; manifest-src 'self'; base-uri 'none';"
          + " form-action 'none'; frame-ancestors 'none'";

  /** Documents and files are users': looked at, never run. */
  private static final String DATA_POLICY = "default-src 'none'; frame-ancestors 'none'; sandbox";

  private final Set<String> hosts;

  Guard(SitafSettings settings) {
    Set<String> all = new HashSet<>(LOOPBACK);
    settings.publicHosts().forEach(host -> all.add(host.toLowerCase(Locale.ROOT)));
    hosts = Set.copyOf(all);
  }

  @Override
  protected void doFilterInternal(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws ServletException, IOException {
    protect(request, response);
    String host = request.getHeader(HttpHeaders.HOST);
    String origin = request.getHeader(HttpHeaders.ORIGIN);
    if (host == null || !hosts.contains(nameOf(host))) {
      refuse(
          response,
          HttpStatus.MISDIRECTED_REQUEST,
          "This server is not known under that host name; sitaf.public-hosts lists its names.");
    } else if (origin != null && !isOwn(origin, host)) {
      refuse(response, HttpStatus.FORBIDDEN, "Requests of pages of other sites are refused.");
    } else {
      chain.doFilter(request, response);
    }
  }

  private static void protect(HttpServletRequest request, HttpServletResponse response) {
    boolean data = request.getRequestURI().startsWith("/api/");
    response.setHeader("Content-Security-Policy", data ? DATA_POLICY : PORTAL_POLICY);
    response.setHeader("X-Content-Type-Options", "nosniff");
    response.setHeader("Referrer-Policy", "no-referrer");
    response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
    response.setHeader("Cross-Origin-Resource-Policy", "same-origin");
    if (data) {
      response.setHeader(HttpHeaders.CACHE_CONTROL, "no-store");
    }
  }

  private static void refuse(HttpServletResponse response, HttpStatus status, String detail)
      throws IOException {
    response.setStatus(status.value());
    response.setContentType(MediaType.APPLICATION_PROBLEM_JSON_VALUE);
    response
        .getWriter()
        .write(
            "{\"title\":\"%s\",\"status\":%d,\"detail\":\"%s\"}"
                .formatted(status.getReasonPhrase(), status.value(), detail));
  }

  /** Same host and port; the scheme may differ behind a proxy that ends TLS. */
  private static boolean isOwn(String origin, String host) {
    @Nullable String authority =
        origin.startsWith("http://")
            ? origin.substring(7)
            : origin.startsWith("https://") ? origin.substring(8) : null;
    return authority != null && authority.equalsIgnoreCase(host);
  }

  private static String nameOf(String host) {
    String lower = host.toLowerCase(Locale.ROOT);
    int colon = lower.lastIndexOf(':');
    return colon > lower.lastIndexOf(']') ? lower.substring(0, colon) : lower;
  }
}
