package org.sitaf.server.access;

import java.io.Serializable;
import java.security.Principal;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.springframework.security.authentication.UsernamePasswordAuthenticationToken;
import org.springframework.security.core.Authentication;
import org.springframework.security.core.authority.SimpleGrantedAuthority;
import org.springframework.security.core.context.SecurityContextHolder;

/**
 * The authenticated caller of a request.
 *
 * @param name of the user, or of the token's owner
 * @param role the permissions of the request
 * @param personId the user's id; null for the launcher
 */
public record Caller(String name, Role role, Kind kind, @Nullable String personId)
    implements Principal, Serializable {
  private static final long serialVersionUID = 1L;
  private static final String ANONYMOUS = "-";

  /** How the caller was authenticated. */
  public enum Kind {
    /** A user with a session. */
    PERSON,
    /** A script with a user's API token. */
    TOKEN,
    /** The command that started this server on its own machine. */
    LAUNCHER
  }

  @Override
  public String getName() {
    return name;
  }

  /** The caller as Spring Security stores it. */
  public Authentication authentication() {
    List<SimpleGrantedAuthority> authorities =
        role.all().stream().map(r -> new SimpleGrantedAuthority("ROLE_" + r)).toList();
    return UsernamePasswordAuthenticationToken.authenticated(this, null, authorities);
  }

  /**
   * The caller of the current request.
   *
   * @throws IllegalStateException if the request is not authenticated
   */
  public static Caller current() {
    Authentication authentication = SecurityContextHolder.getContext().getAuthentication();
    if (authentication != null && authentication.getPrincipal() instanceof Caller caller) {
      return caller;
    }
    throw new IllegalStateException("the request is not authenticated");
  }

  /** Whether the current request is authenticated. */
  public static boolean isKnown() {
    return !currentName().equals(ANONYMOUS);
  }

  /** The name of the current caller, or {@code -} if the request is not authenticated. */
  public static String currentName() {
    Authentication authentication = SecurityContextHolder.getContext().getAuthentication();
    return authentication != null && authentication.getPrincipal() instanceof Caller caller
        ? caller.name()
        : ANONYMOUS;
  }
}
