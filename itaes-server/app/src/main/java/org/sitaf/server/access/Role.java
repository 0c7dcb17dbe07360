package org.sitaf.server.access;

import java.util.Arrays;
import java.util.List;

/** What somebody may do; each role may do what those before it may. */
public enum Role {
  /** Looks at everything but users, keys and the audit log. */
  VIEWER,
  /** Changes activities and has them built. */
  TESTER,
  /** Lets people and agents in. */
  ADMINISTRATOR;

  /** Whether this role may do what the other may. */
  public boolean includes(Role other) {
    return compareTo(other) >= 0;
  }

  /** This role and those that it includes. */
  public List<Role> all() {
    return Arrays.stream(values()).filter(this::includes).toList();
  }

  /** The lower of both. */
  public Role atMost(Role limit) {
    return includes(limit) ? limit : this;
  }
}
