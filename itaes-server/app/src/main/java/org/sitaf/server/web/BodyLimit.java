package org.sitaf.server.web;

import jakarta.servlet.FilterChain;
import jakarta.servlet.ReadListener;
import jakarta.servlet.ServletException;
import jakarta.servlet.ServletInputStream;
import jakarta.servlet.http.HttpServletRequest;
import jakarta.servlet.http.HttpServletRequestWrapper;
import jakarta.servlet.http.HttpServletResponse;
import java.io.IOException;
import org.sitaf.server.refusal.Refusal;
import org.springframework.http.MediaType;
import org.springframework.stereotype.Component;
import org.springframework.util.unit.DataSize;
import org.springframework.web.filter.OncePerRequestFilter;

/**
 * JSON is held in memory as a whole, so its size is bounded, and is small before anybody has signed
 * in. Other bodies are read piece by piece, as {@link Requests#body} bounds them.
 */
@Component
class BodyLimit extends OncePerRequestFilter {
  private static final DataSize MOST = DataSize.ofMegabytes(64);
  private static final DataSize MOST_OF_SIGN_IN = DataSize.ofKilobytes(64);
  private static final String SIGN_IN = "/api/v1/session";

  @Override
  protected void doFilterInternal(
      HttpServletRequest request, HttpServletResponse response, FilterChain chain)
      throws ServletException, IOException {
    boolean json =
        request.getContentType() != null
            && request.getContentType().startsWith(MediaType.APPLICATION_JSON_VALUE);
    if (request.getRequestURI().startsWith(SIGN_IN)) {
      chain.doFilter(new Limited(request, MOST_OF_SIGN_IN), response);
    } else if (json) {
      chain.doFilter(new Limited(request, MOST), response);
    } else {
      chain.doFilter(request, response);
    }
  }

  private static final class Limited extends HttpServletRequestWrapper {
    private final DataSize most;

    Limited(HttpServletRequest request, DataSize most) {
      super(request);
      this.most = most;
    }

    @Override
    public ServletInputStream getInputStream() throws IOException {
      if (getContentLengthLong() > most.toBytes()) {
        throw tooLarge(most);
      }
      return new Counted(super.getInputStream(), most);
    }
  }

  /** What a client does not announce is counted as it comes. */
  private static final class Counted extends ServletInputStream {
    private final ServletInputStream in;
    private final DataSize most;
    private long left;

    Counted(ServletInputStream in, DataSize most) {
      this.in = in;
      this.most = most;
      this.left = most.toBytes();
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

    private int count(int answer, int bytes) {
      left -= bytes;
      if (left < 0) {
        throw tooLarge(most);
      }
      return answer;
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

  private static Refusal tooLarge(DataSize most) {
    return Refusal.tooLarge("The JSON is larger than " + most.toKilobytes() + " KiB.");
  }
}
