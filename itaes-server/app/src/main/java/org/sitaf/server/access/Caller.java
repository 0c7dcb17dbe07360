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
 * Who makes a request.
 *
 * @param name of the person, or whose token it is
 * @param role what the request may do
 * @param personId null for the launcher
 */
public record Caller(String name, Role role, Kind kind, @Nullable String personId)
    implements Principal, Serializable {
  private static final long serialVersionUID = 1L;
  private static final String NOBODY = "-";

  /** How the caller has shown who it is. */
  public enum Kind {
    /** A person, by a session. */
    PERSON,
    /** A script, by a token of a person. */
    TOKEN,
    /** The command that started this server on its own machine. */
    LAUNCHER
  }

  @Override
  public String getName() {
    return name;
  }

  /** What Spring Security keeps of the caller. */
  public Authentication authentication() {
    List<SimpleGrantedAuthority> authorities =
        role.all().stream().map(r -> new SimpleGrantedAuthority("ROLE_" + r)).toList();
    return UsernamePasswordAuthenticationToken.authenticated(this, null, authorities);
  }

  /**
   * The caller of the present request.
   *
   * @throws IllegalStateException when nobody is known, which the filters do not let happen
   */
  public static Caller current() {
    Authentication present = SecurityContextHolder.getContext().getAuthentication();
    if (present != null && present.getPrincipal() instanceof Caller caller) {
      return caller;
    }
    throw new IllegalStateException("nobody is signed in");
  }

  /** Whether anybody is known to make the present request. */
  public static boolean isKnown() {
    return !currentName().equals(NOBODY);
  }

  /** The name of the present caller, or a dash. */
  public static String currentName() {
    Authentication present = SecurityContextHolder.getContext().getAuthentication();
    return present != null && present.getPrincipal() instanceof Caller caller
        ? caller.name()
        : NOBODY;
  }
}
