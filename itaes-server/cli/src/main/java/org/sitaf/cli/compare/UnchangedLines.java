package org.sitaf.cli.compare;

import java.util.HashMap;
import java.util.Map;
import org.eclipse.jgit.diff.Edit;
import org.eclipse.jgit.diff.EditList;
import org.eclipse.jgit.diff.HistogramDiff;
import org.eclipse.jgit.diff.RawText;
import org.eclipse.jgit.diff.RawTextComparator;
import org.sitaf.core.activity.FileTree;

/** Finds the lines of a file that two versions have in common. */
final class UnchangedLines {
  private final FileTree base;
  private final FileTree now;
  private final Map<String, EditList> edits = new HashMap<>();

  UnchangedLines(FileTree base, FileTree now) {
    this.base = base;
    this.now = now;
  }

  /**
   * The number in the new version of a line of the base version.
   *
   * @param line from 1
   * @return 0 if the line was changed or removed
   */
  int inNew(String path, int line) {
    int moved = 0;
    for (Edit edit : edits.computeIfAbsent(path, this::diff)) {
      if (line - 1 < edit.getBeginA()) {
        break;
      }
      if (line - 1 < edit.getEndA()) {
        return 0;
      }
      moved += edit.getLengthB() - edit.getLengthA();
    }
    return base.contains(path) && now.contains(path) ? line + moved : 0;
  }

  private EditList diff(String path) {
    return new HistogramDiff()
        .diff(
            RawTextComparator.WS_IGNORE_TRAILING,
            new RawText(base.content(path).orElse(new byte[0])),
            new RawText(now.content(path).orElse(new byte[0])));
  }
}
