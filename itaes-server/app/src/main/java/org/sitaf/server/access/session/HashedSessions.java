package org.sitaf.server.access.session;

import jakarta.servlet.http.HttpServletRequest;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.server.access.Secret;
import org.springframework.beans.factory.ObjectProvider;
import org.springframework.beans.factory.config.BeanPostProcessor;
import org.springframework.context.annotation.Bean;
import org.springframework.context.annotation.Configuration;
import org.springframework.session.SessionIdGenerator;
import org.springframework.session.web.http.CookieSerializer;
import org.springframework.session.web.http.DefaultCookieSerializer;

/**
 * Stores sessions under the hash of their id; only the browser has the id itself. Read access to
 * the database is not enough to hijack a session.
 */
@Configuration(proxyBeanMethods = false)
class HashedSessions {
  @Bean
  static HashedIdGenerator sessionIds() {
    return new HashedIdGenerator();
  }

  @Bean
  static BeanPostProcessor hashedCookies(ObjectProvider<HashedIdGenerator> ids) {
    return new BeanPostProcessor() {
      @Override
      public Object postProcessAfterInitialization(Object bean, String name) {
        return bean instanceof DefaultCookieSerializer cookies
            ? new HashedCookies(cookies, ids.getObject())
            : bean;
      }
    };
  }

  /** Generates ids and keeps each one in memory until its cookie is written. */
  static final class HashedIdGenerator implements SessionIdGenerator {
    private static final int MAX_PENDING = 1_000;
    private final Map<String, String> idByHash =
        new LinkedHashMap<>() {
          private static final long serialVersionUID = 1L;

          @Override
          protected boolean removeEldestEntry(Map.Entry<String, String> eldest) {
            return size() > MAX_PENDING;
          }
        };

    @Override
    public synchronized String generate() {
      String id = Secret.generate("");
      String hash = Secret.hash(id);
      idByHash.put(hash, id);
      return hash;
    }

    /** The id of a new session; for other sessions the hash, which is not a valid id. */
    private synchronized String remove(String hash) {
      String id = idByHash.remove(hash);
      return id == null ? hash : id;
    }
  }

  private record HashedCookies(CookieSerializer cookies, HashedIdGenerator ids)
      implements CookieSerializer {
    @Override
    public void writeCookieValue(CookieValue value) {
      String session = value.getCookieValue();
      cookies.writeCookieValue(
          session.isEmpty()
              ? value
              : new CookieValue(value.getRequest(), value.getResponse(), ids.remove(session)));
    }

    @Override
    public List<String> readCookieValues(HttpServletRequest request) {
      return cookies.readCookieValues(request).stream().map(Secret::hash).toList();
    }
  }
}
