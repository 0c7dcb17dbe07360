package org.sitaf.server.access;

import java.util.Arrays;
import java.util.List;

/** A role, with the permissions of all roles before it. */
public enum Role {
  /** Reads everything except users, keys and the audit log. */
  VIEWER,
  /** Changes activities and runs builds. */
  TESTER,
  /** Runs builds that use real devices, which move. */
  OPERATOR,
  /** Manages users and agents. */
  ADMINISTRATOR;

  /** Whether this role has all permissions of the other. */
  public boolean includes(Role other) {
    return compareTo(other) >= 0;
  }

  /** This role and all roles that it includes. */
  public List<Role> all() {
    return Arrays.stream(values()).filter(this::includes).toList();
  }

  /** The lower of the two roles. */
  public Role atMost(Role limit) {
    return includes(limit) ? limit : this;
  }
}
