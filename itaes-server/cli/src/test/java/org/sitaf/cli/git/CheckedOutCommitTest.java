package org.sitaf.cli.git;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.eclipse.jgit.dircache.DirCache;
import org.eclipse.jgit.dircache.DirCacheEntry;
import org.eclipse.jgit.lib.CommitBuilder;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectInserter;
import org.eclipse.jgit.lib.PersonIdent;
import org.eclipse.jgit.lib.RefUpdate;
import org.eclipse.jgit.lib.Repository;
import org.eclipse.jgit.storage.file.FileRepositoryBuilder;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.activity.FileTree;

class CheckedOutCommitTest {
  @TempDir private Path directory;

  private String commit(String path, String text) throws IOException {
    try (Repository repository =
        new FileRepositoryBuilder().setWorkTree(directory.toFile()).build()) {
      repository.create();
      DirCache index = DirCache.newInCore();
      try (ObjectInserter objects = repository.newObjectInserter()) {
        DirCacheEntry entry = new DirCacheEntry(path);
        entry.setFileMode(FileMode.REGULAR_FILE);
        entry.setObjectId(
            objects.insert(org.eclipse.jgit.lib.Constants.OBJ_BLOB, text.getBytes(UTF_8)));
        var builder = index.builder();
        builder.add(entry);
        builder.finish();
        CommitBuilder commit = new CommitBuilder();
        commit.setTreeId(index.writeTree(objects));
        commit.setAuthor(new PersonIdent("Ada", "ada@example"));
        commit.setCommitter(commit.getAuthor());
        commit.setMessage("Begin");
        ObjectId id = objects.insert(commit);
        objects.flush();
        RefUpdate head = repository.updateRef("HEAD");
        head.setNewObjectId(id);
        head.update();
        return id.name();
      }
    }
  }

  private static FileTree files(String text) {
    return FileTree.of(Map.of("activity.yaml", text.getBytes(UTF_8)));
  }

  @Test
  void a_checkout_has_the_commit_of_its_files() throws IOException {
    String id = commit("arm/activity.yaml", "name: arm");
    Path folder = Files.createDirectory(directory.resolve("arm"));
    assertThat(CheckedOutCommit.of(folder, files("name: arm"))).contains(id);
    assertThat(CheckedOutCommit.of(folder, files("name: leg"))).contains(id + "-dirty");
  }

  @Test
  void a_folder_that_is_not_committed_differs_from_the_commit() throws IOException {
    String id = commit("other/activity.yaml", "name: other");
    Path folder = Files.createDirectory(directory.resolve("arm"));
    assertThat(CheckedOutCommit.of(folder, files("name: arm"))).contains(id + "-dirty");
  }

  @Test
  void a_folder_without_a_repository_has_no_commit() {
    assertThat(CheckedOutCommit.of(directory, files("name: arm"))).isEmpty();
  }
}
