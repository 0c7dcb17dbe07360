package org.sitaf.agent.sandbox.cgroup;

/**
 * A machine that gives this user none.
 *
 * @param reason why
 */
record NoControlGroups(String reason) implements ControlGroups {
  @Override
  public String description() {
    return reason;
  }

  @Override
  public boolean bindMemory() {
    return false;
  }

  @Override
  public boolean shareProcessors() {
    return false;
  }

  @Override
  public ControlGroup make(GroupLimits limits) {
    return ControlGroup.NONE;
  }
}
