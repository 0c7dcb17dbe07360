package org.sitaf.server.git.remote;

import java.io.IOException;
import java.io.InputStream;
import java.net.Proxy;
import java.net.URL;
import org.eclipse.jgit.transport.http.HttpConnection;
import org.eclipse.jgit.transport.http.HttpConnectionFactory;
import org.eclipse.jgit.transport.http.JDKHttpConnection;

/** Makes HTTP connections whose responses are read within limits. */
final class LimitedConnections implements HttpConnectionFactory {
  private final FetchLimits limits;

  LimitedConnections(FetchLimits limits) {
    this.limits = limits;
  }

  @Override
  public HttpConnection create(URL url) throws IOException {
    return new Limited(url, limits);
  }

  @Override
  public HttpConnection create(URL url, Proxy proxy) throws IOException {
    return new Limited(url, proxy, limits);
  }

  private static final class Limited extends JDKHttpConnection {
    private final FetchLimits limits;

    Limited(URL url, FetchLimits limits) throws IOException {
      super(url);
      this.limits = limits;
    }

    Limited(URL url, Proxy proxy, FetchLimits limits) throws IOException {
      super(url, proxy);
      this.limits = limits;
    }

    @Override
    public InputStream getInputStream() throws IOException {
      return limits.advertisement(super.getInputStream());
    }
  }
}
