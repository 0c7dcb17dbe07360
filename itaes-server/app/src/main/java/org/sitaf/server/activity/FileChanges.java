package org.sitaf.server.activity;

import io.swagger.v3.oas.annotations.media.Schema;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.server.error.RequestException;

/** Changes of several files of an activity, which are applied and verified together. */
@Schema(name = "FileChanges")
record FileChanges(List<FileChange> changes) {

  @Schema(name = "FileChange")
  record FileChange(
      String path,
      @Schema(description = "the new text; absent to delete the file") @Nullable String content) {}

  /** Returns the files after the changes. */
  FileTree applyTo(FileTree tree) {
    Map<String, byte[]> files = new HashMap<>();
    tree.paths().forEach(path -> files.put(path, tree.content(path).orElseThrow()));
    for (FileChange change : changes) {
      if (change.path() == null) {
        throw RequestException.malformed("changes.path must be given.");
      }
      if (change.content() == null) {
        if (files.remove(change.path()) == null) {
          throw RequestException.notFound("file", change.path());
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
