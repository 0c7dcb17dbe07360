package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.refusal.Refusal;

/** Several files of an activity, changed at once, because it must hold together as a whole. */
@Schema(name = "FileChanges")
record FileChanges(List<FileChange> changes) {

  @Schema(name = "FileChange")
  record FileChange(
      String path,
      @Schema(description = "the file's new text; absent to remove the file")
          @Nullable String content) {}

  /** The files after the changes. */
  FileTree applyTo(FileTree tree) {
    Map<String, byte[]> files = new HashMap<>();
    tree.paths().forEach(path -> files.put(path, tree.content(path).orElseThrow()));
    for (FileChange change : changes) {
      if (change.path() == null) {
        throw Refusal.malformed("A change needs the path of its file.");
      }
      if (change.content() == null) {
        if (files.remove(change.path()) == null) {
          throw Refusal.notFound("file", change.path());
        }
      } else {
        files.put(change.path(), change.content().getBytes(StandardCharsets.UTF_8));
      }
    }
    try {
      return FileTree.of(files);
    } catch (IllegalArgumentException e) {
      throw InvalidInputException.of("the changes", String.valueOf(e.getMessage()));
    }
  }
}
