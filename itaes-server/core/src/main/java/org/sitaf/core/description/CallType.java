package org.sitaf.core.description;

/** Whether the caller waits for the method to end. */
public enum CallType {
  BLOCKING,
  NONBLOCKING
}
