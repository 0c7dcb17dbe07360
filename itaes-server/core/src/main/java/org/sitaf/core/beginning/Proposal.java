package org.sitaf.core.beginning;

import java.util.List;
import org.sitaf.core.activity.FileTree;

/**
 * A new activity.
 *
 * @param notes what is left out, and what a person has to add
 */
public record Proposal(FileTree files, List<String> notes) {
  public Proposal {
    notes = notes.stream().distinct().toList();
  }
}
