package org.sitaf.agent.sandbox.seccomp;

import java.util.Optional;

/** Processor architectures with known system call numbers. */
enum Architecture {
  X86_64(0xC000003E, "amd64"),
  AARCH64(0xC00000B7, "aarch64");

  private final int audit;
  private final String name;

  Architecture(int audit, String name) {
    this.audit = audit;
    this.name = name;
  }

  /** The kernel's constant, {@code AUDIT_ARCH_*} of {@code linux/audit.h}. */
  int audit() {
    return audit;
  }

  /** The architecture of this machine; empty if it is not supported. */
  static Optional<Architecture> ofThisMachine() {
    String machine = System.getProperty("os.arch", "");
    for (Architecture architecture : values()) {
      if (architecture.name.equals(machine)) {
        return Optional.of(architecture);
      }
    }
    return Optional.empty();
  }
}
