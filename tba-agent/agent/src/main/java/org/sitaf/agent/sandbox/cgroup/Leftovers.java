package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** What agents left that were killed: their groups, and whatever is still in them. */
final class Leftovers {
  private Leftovers() {}

  static void sweep(GroupFiles files, Path parent) throws IOException {
    for (Path group : files.groupsIn(parent)) {
      Optional<Owner> owner = Owner.ofGroup(group.getFileName().toString());
      if (owner.isPresent() && owner.get().isGone()) {
        new ControlGroup(files, List.of(group), null).remove();
      }
    }
  }
}
