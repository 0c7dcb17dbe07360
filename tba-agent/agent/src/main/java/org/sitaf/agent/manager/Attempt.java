package org.sitaf.agent.manager;

import java.nio.charset.StandardCharsets;
import java.util.UUID;
import org.sitaf.agent.v1.AttemptRef;

/** Identifies an attempt, with a name that is safe for files whatever the build's id contains. */
record Attempt(AttemptRef ref, String key) {
  static Attempt of(AttemptRef ref) {
    String text = ref.getBuildId() + "/" + ref.getAttempt() + "/" + ref.getFencingToken();
    return new Attempt(
        ref, UUID.nameUUIDFromBytes(text.getBytes(StandardCharsets.UTF_8)).toString());
  }

  @Override
  public String toString() {
    return "build " + ref.getBuildId() + ", attempt " + ref.getAttempt();
  }
}
