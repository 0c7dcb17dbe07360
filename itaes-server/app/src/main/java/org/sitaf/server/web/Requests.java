package org.sitaf.server.web;

import jakarta.servlet.http.HttpServletRequest;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.stereotype.Component;

/** Reads request bodies of limited size and {@code If-Match} headers. */
@Component
public class Requests {
  /** Documents are held in memory; parsing them takes several times their size. */
  private static final long MAX_DOCUMENT = 64 << 20;

  private final long maxUpload;

  Requests(SitafSettings settings) {
    maxUpload = settings.maxUpload().toBytes();
  }

  /** The request body; reading beyond the limit throws a {@link RequestException}. */
  public InputStream body(HttpServletRequest request) throws IOException {
    boolean archive = String.valueOf(request.getContentType()).startsWith("application/zip");
    long maxBytes = archive ? maxUpload : Math.min(maxUpload, MAX_DOCUMENT);
    if (request.getContentLengthLong() > maxBytes) {
      throw tooLarge(maxBytes);
    }
    return new FilterInputStream(request.getInputStream()) {
      private long left = maxBytes;

      @Override
      public int read() throws IOException {
        int read = in.read();
        if (read >= 0) {
          count(1);
        }
        return read;
      }

      @Override
      public int read(byte[] buffer, int offset, int length) throws IOException {
        int read = in.read(buffer, offset, length);
        return read < 0 ? read : count(read);
      }

      private int count(int read) {
        left -= read;
        if (left < 0) {
          throw tooLarge(maxBytes);
        }
        return read;
      }
    };
  }

  /** Parses an {@code If-Match} header. */
  public static Expected expected(String ifMatch) {
    if (ifMatch.strip().equals("*")) {
      return Expected.ANY;
    }
    try {
      return Expected.version(Long.parseLong(ifMatch.replace("\"", "").strip()));
    } catch (NumberFormatException e) {
      throw RequestException.malformed(
          "If-Match must be a version, such as \"3\", not " + ifMatch + ".");
    }
  }

  /**
   * The version of a resource to which a change applies.
   *
   * @param version null for any
   */
  public record Expected(@Nullable Long version) {
    /** Any version. */
    public static final Expected ANY = new Expected(null);

    /** A single version. */
    public static Expected version(long version) {
      return new Expected(version);
    }

    public boolean isAny() {
      return version == null;
    }

    /**
     * Checks the version of a resource.
     *
     * @throws RequestException if it has another version
     */
    public void require(String what, long current) {
      if (version != null && version != current) {
        throw RequestException.outdated(what, current);
      }
    }
  }

  private static RequestException tooLarge(long maxBytes) {
    return RequestException.tooLarge("The body is larger than " + (maxBytes >> 20) + " MiB.");
  }
}
