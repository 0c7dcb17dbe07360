package org.sitaf.server.web;

import jakarta.servlet.http.HttpServletRequest;
import java.io.FilterInputStream;
import java.io.IOException;
import java.io.InputStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.server.refusal.Refusal;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.stereotype.Component;

/**
 * What requests bring besides JSON: bodies of bounded size, and the version that a change is meant
 * for.
 */
@Component
public class Requests {
  /**
   * Documents are read into memory as a whole, and into several times as much when they are read.
   */
  private static final long MAX_DOCUMENT = 64 << 20;

  private final long maxUpload;

  Requests(SitafSettings settings) {
    maxUpload = settings.maxUpload().toBytes();
  }

  /** The body; reading beyond the limit ends in a {@link Refusal}. */
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

  /** The version that a change is made to, from an {@code If-Match} header. */
  public static Expected expected(String ifMatch) {
    if (ifMatch.strip().equals("*")) {
      return Expected.ANY;
    }
    try {
      return Expected.version(Long.parseLong(ifMatch.replace("\"", "").strip()));
    } catch (NumberFormatException e) {
      throw Refusal.malformed("If-Match must be a version, such as \"3\", not " + ifMatch + ".");
    }
  }

  /**
   * Which version of a resource a change is made to.
   *
   * @param version null for any
   */
  public record Expected(@Nullable Long version) {
    /** Whatever the version is. */
    public static final Expected ANY = new Expected(null);

    /** One version. */
    public static Expected version(long version) {
      return new Expected(version);
    }

    public boolean isAny() {
      return version == null;
    }

    /**
     * Makes sure that the resource has this version.
     *
     * @throws Refusal when it has another one
     */
    public void require(String what, long present) {
      if (version != null && version != present) {
        throw Refusal.outdated(what, present);
      }
    }
  }

  private static Refusal tooLarge(long maxBytes) {
    return Refusal.tooLarge("The body is larger than " + (maxBytes >> 20) + " MiB.");
  }
}
