package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;

/** Groups that killed agents left, with the processes in them. */
final class StaleGroups {
  private StaleGroups() {}

  static void removeAll(GroupFiles files, Path parent) throws IOException {
    for (Path group : files.subgroups(parent)) {
      Optional<GroupOwner> owner = GroupOwner.ofGroup(group.getFileName().toString());
      if (owner.isPresent() && owner.get().isGone()) {
        new ControlGroup(files, List.of(group), null, null).remove();
      }
    }
  }
}
