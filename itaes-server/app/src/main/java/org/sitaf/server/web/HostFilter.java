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
 * Protects users' browsers from other sites: rejects requests with an unknown host name (DNS
 * rebinding) or a foreign origin, and sets security headers so that only the portal's own scripts
 * run.
 */
@Component
@Order(Ordered.HIGHEST_PRECEDENCE)
class HostFilter extends OncePerRequestFilter {
  private static final Set<String> LOOPBACK = Set.of("localhost", "127.0.0.1", "[::1]");
  private static final String PORTAL_POLICY =
      "default-src 'none'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self'"
          + " data:; font-src 'self' data:; connect-src 'self'; manifest-src 'self'; base-uri"
          + " 'none'; form-action 'none'; frame-ancestors 'none'";

  /** Documents and files come from users; browsers must not execute them. */
  private static final String DATA_POLICY = "default-src 'none'; frame-ancestors 'none'; sandbox";

  /** The site generator writes scripts into its pages, and searches in a worker. */
  private static final String DOCUMENTATION_POLICY =
      "default-src 'none'; script-src 'self' 'unsafe-inline'; style-src 'self' 'unsafe-inline';"
          + " img-src 'self' data:; font-src 'self'; connect-src 'self'; worker-src 'self'; base-uri"
          + " 'none'; form-action 'self'; frame-ancestors 'none'";

  private final Set<String> hosts;

  HostFilter(SitafSettings settings) {
    Set<String> all = new HashSet<>(LOOPBACK);
    settings.publicHosts().forEach(host -> all.add(host.toLowerCase(Locale.ROOT)));
    hosts = Set.copyOf(all);
  }

  @Override
  protected void doFilterInternal(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws ServletException, IOException {
    setSecurityHeaders(request, response);
    String host = request.getHeader(HttpHeaders.HOST);
    String origin = request.getHeader(HttpHeaders.ORIGIN);
    if (host == null || !hosts.contains(hostName(host))) {
      reject(
          response,
          HttpStatus.MISDIRECTED_REQUEST,
          "Unknown host name; sitaf.public-hosts lists the server's names.");
    } else if (origin != null && !isSameOrigin(origin, host)) {
      reject(response, HttpStatus.FORBIDDEN, "Cross-origin requests are rejected.");
    } else {
      chain.doFilter(request, response);
    }
  }

  private static void setSecurityHeaders(HttpServletRequest request, HttpServletResponse response) {
    boolean data = request.getRequestURI().startsWith("/api/");
    boolean documentation = request.getRequestURI().startsWith(Documentation.PATH);
    response.setHeader(
        "Content-Security-Policy",
        data ? DATA_POLICY : documentation ? DOCUMENTATION_POLICY : PORTAL_POLICY);
    response.setHeader("X-Content-Type-Options", "nosniff");
    response.setHeader("Referrer-Policy", "no-referrer");
    response.setHeader("Cross-Origin-Opener-Policy", "same-origin");
    response.setHeader("Cross-Origin-Resource-Policy", "same-origin");
    if (data) {
      response.setHeader(HttpHeaders.CACHE_CONTROL, "no-store");
    }
  }

  private static void reject(HttpServletResponse response, HttpStatus status, String detail)
      throws IOException {
    response.setStatus(status.value());
    response.setContentType(MediaType.APPLICATION_PROBLEM_JSON_VALUE);
    response
        .getWriter()
        .write(
            "{\"title\":\"%s\",\"status\":%d,\"detail\":\"%s\"}"
                .formatted(status.getReasonPhrase(), status.value(), detail));
  }

  /** Compares host and port; the scheme may differ behind a proxy that terminates TLS. */
  private static boolean isSameOrigin(String origin, String host) {
    @Nullable String authority =
        origin.startsWith("http://")
            ? origin.substring(7)
            : origin.startsWith("https://") ? origin.substring(8) : null;
    return authority != null && authority.equalsIgnoreCase(host);
  }

  private static String hostName(String host) {
    String lower = host.toLowerCase(Locale.ROOT);
    int colon = lower.lastIndexOf(':');
    return colon > lower.lastIndexOf(']') ? lower.substring(0, colon) : lower;
  }
}
