package org.sitaf.server.web;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ReadListener;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletInputStream;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.sitaf.server.error.RequestException;
import org.springframework.http.MediaType;
import org.springframework.stereotype.Component;
import org.springframework.util.unit.DataSize;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * Limits the size of JSON bodies, which are held in memory. The limit for signing in is smaller
 * because those requests are not authenticated. {@link Requests#body} limits other bodies.
 */
@Component
class BodyLimit extends OncePerRequestFilter {
  private static final DataSize LIMIT = DataSize.ofMegabytes(64);
  private static final DataSize SIGN_IN_LIMIT = DataSize.ofKilobytes(64);
  private static final String SIGN_IN = "/api/v1/session";

  /** Messages of forges are not authenticated before they were read. */
  private static final DataSize HOOK_LIMIT = DataSize.ofMegabytes(2);

  private static final String HOOKS = "/api/v1/git-hooks";

  @Override
  protected void doFilterInternal(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws ServletException, IOException {
    boolean json =
        request.getContentType() != null
            && request.getContentType().startsWith(MediaType.APPLICATION_JSON_VALUE);
    if (request.getRequestURI().startsWith(SIGN_IN)) {
      chain.doFilter(new LimitedRequest(request, SIGN_IN_LIMIT), response);
    } else if (request.getRequestURI().startsWith(HOOKS)) {
      chain.doFilter(new LimitedRequest(request, HOOK_LIMIT), response);
    } else if (json) {
      chain.doFilter(new LimitedRequest(request, LIMIT), response);
    } else {
      chain.doFilter(request, response);
    }
  }

  private static final class LimitedRequest extends HttpServletRequestWrapper {
    private final DataSize limit;

    LimitedRequest(HttpServletRequest request, DataSize limit) {
      super(request);
      this.limit = limit;
    }

    @Override
    public ServletInputStream getInputStream() throws IOException {
      if (getContentLengthLong() > limit.toBytes()) {
        throw tooLarge(limit);
      }
      return new CountingStream(super.getInputStream(), limit);
    }
  }

  /** Enforces the limit for bodies without a Content-Length header. */
  private static final class CountingStream extends ServletInputStream {
    private final ServletInputStream in;
    private final DataSize limit;
    private long left;

    CountingStream(ServletInputStream in, DataSize limit) {
      this.in = in;
      this.limit = limit;
      this.left = limit.toBytes();
    }

    @Override
    public int read() throws IOException {
      int read = in.read();
      return read < 0 ? read : count(read, 1);
    }

    @Override
    public int read(byte[] buffer, int offset, int length) throws IOException {
      int read = in.read(buffer, offset, length);
      return read < 0 ? read : count(read, read);
    }

    private int count(int result, int bytes) {
      left -= bytes;
      if (left < 0) {
        throw tooLarge(limit);
      }
      return result;
    }

    @Override
    public boolean isFinished() {
      return in.isFinished();
    }

    @Override
    public boolean isReady() {
      return in.isReady();
    }

    @Override
    public void setReadListener(ReadListener listener) {
      in.setReadListener(listener);
    }
  }

  private static RequestException tooLarge(DataSize limit) {
    return RequestException.tooLarge(
        "The JSON body is larger than " + limit.toKilobytes() + " KiB.");
  }
}
