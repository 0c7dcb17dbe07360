package org.sitaf.agent.sandbox.cgroup;

/**
 * A machine on which this user may not create control groups.
 *
 * @param reason why not
 */
record NoControlGroups(String reason) implements ControlGroups {
  @Override
  public String description() {
    return reason;
  }

  @Override
  public boolean limitsMemory() {
    return false;
  }

  @Override
  public boolean sharesCpu() {
    return false;
  }

  @Override
  public ControlGroup create(GroupLimits limits) {
    return ControlGroup.NONE;
  }
}
