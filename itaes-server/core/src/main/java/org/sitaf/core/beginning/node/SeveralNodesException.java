package org.sitaf.core.beginning.node;

import java.util.List;

/** A package holds several nodes, of which the user has to choose one. */
public final class SeveralNodesException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final String packageName;
  private final transient List<String> nodes;

  SeveralNodesException(String packageName, List<String> nodes) {
    super(packageName + " holds several nodes; choose one of: " + String.join(", ", nodes));
    this.packageName = packageName;
    this.nodes = List.copyOf(nodes);
  }

  public String packageName() {
    return packageName;
  }

  /** Their classes and programs, as {@code activity.yaml} names them. */
  public List<String> nodes() {
    return nodes;
  }
}
