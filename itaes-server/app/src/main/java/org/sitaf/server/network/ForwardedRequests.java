package org.sitaf.server.network;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ServletException;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import java.util.Collections;
import org.jspecify.annotations.Nullable;
import org.springframework.core.Ordered;
import org.springframework.core.annotation.Order;
import org.springframework.stereotype.Component;
import org.springframework.web.filter.OncePerRequestFilter;

/** Replaces the proxy's address and scheme with those of the client, for all later filters. */
@Component
@Order(Ordered.HIGHEST_PRECEDENCE)
class ForwardedRequests extends OncePerRequestFilter {
  private final TrustedProxies proxies;

  ForwardedRequests(TrustedProxies proxies) {
    this.proxies = proxies;
  }

  @Override
  protected void doFilterInternal(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws ServletException, IOException {
    TrustedProxies.Client client =
        proxies.client(request.getRemoteAddr(), name -> Collections.list(request.getHeaders(name)));
    chain.doFilter(new Forwarded(request, client), response);
  }

  private static final class Forwarded extends HttpServletRequestWrapper {
    private final String address;
    private final boolean secure;

    Forwarded(HttpServletRequest request, TrustedProxies.Client client) {
      super(request);
      @Nullable Boolean clientSecure = client.secure();
      this.address = client.address();
      this.secure = clientSecure == null ? request.isSecure() : clientSecure;
    }

    @Override
    public String getRemoteAddr() {
      return address;
    }

    @Override
    public String getRemoteHost() {
      return address;
    }

    @Override
    public boolean isSecure() {
      return secure;
    }

    @Override
    public String getScheme() {
      return secure ? "https" : "http";
    }
  }
}
