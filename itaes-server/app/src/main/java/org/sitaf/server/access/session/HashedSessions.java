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
 * The store of sessions knows each by the hash of its secret, which only the browser has: who reads
 * the database cannot take a session over.
 */
@Configuration(proxyBeanMethods = false)
class HashedSessions {
  @Bean
  static NewSecrets sessionSecrets() {
    return new NewSecrets();
  }

  @Bean
  static BeanPostProcessor hashedCookies(ObjectProvider<NewSecrets> secrets) {
    return new BeanPostProcessor() {
      @Override
      public Object postProcessAfterInitialization(Object bean, String name) {
        return bean instanceof DefaultCookieSerializer cookies
            ? new HashedCookies(cookies, secrets.getObject())
            : bean;
      }
    };
  }

  /** Makes secrets, and keeps each until it is in a cookie. */
  static final class NewSecrets implements SessionIdGenerator {
    private static final int MOST_KEPT = 1_000;

    private final Map<String, String> byHash =
        new LinkedHashMap<>() {
          private static final long serialVersionUID = 1L;

          @Override
          protected boolean removeEldestEntry(Map.Entry<String, String> eldest) {
            return size() > MOST_KEPT;
          }
        };

    @Override
    public synchronized String generate() {
      String secret = Secret.fresh("");
      String hash = Secret.hash(secret);
      byHash.put(hash, secret);
      return hash;
    }

    /**
     * The secret of a session that was made just now; without one its own hash, which opens
     * nothing.
     */
    private synchronized String taken(String hash) {
      String secret = byHash.remove(hash);
      return secret == null ? hash : secret;
    }
  }

  private record HashedCookies(CookieSerializer cookies, NewSecrets secrets)
      implements CookieSerializer {
    @Override
    public void writeCookieValue(CookieValue value) {
      String session = value.getCookieValue();
      cookies.writeCookieValue(
          session.isEmpty()
              ? value
              : new CookieValue(value.getRequest(), value.getResponse(), secrets.taken(session)));
    }

    @Override
    public List<String> readCookieValues(HttpServletRequest request) {
      return cookies.readCookieValues(request).stream().map(Secret::hash).toList();
    }
  }
}
