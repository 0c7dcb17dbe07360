package org.sitaf.cli.git;

import static java.nio.charset.StandardCharsets.UTF_8;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.jgit.dircache.DirCache;
import org.eclipse.jgit.dircache.DirCacheEntry;
import org.eclipse.jgit.internal.storage.file.FileRepository;
import org.eclipse.jgit.lib.CommitBuilder;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectInserter;
import org.eclipse.jgit.lib.PersonIdent;
import org.eclipse.jgit.lib.RefUpdate;
import org.eclipse.jgit.lib.Repository;
import org.eclipse.jgit.lib.TreeFormatter;
import org.eclipse.jgit.storage.file.FileRepositoryBuilder;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

class GitFolderTest {
  @TempDir private Path directory;

  private Repository repository;

  @BeforeEach
  void createRepository() throws IOException {
    repository = new FileRepositoryBuilder().setWorkTree(directory.toFile()).build();
    assertThat(repository).isInstanceOf(FileRepository.class);
    repository.create();
  }

  @AfterEach
  void closeRepository() {
    repository.close();
  }

  private void commit(Object... pathModeContent) throws IOException {
    try (ObjectInserter inserter = repository.newObjectInserter()) {
      DirCache index = DirCache.newInCore();
      var builder = index.builder();
      for (int i = 0; i < pathModeContent.length; i += 3) {
        DirCacheEntry entry = new DirCacheEntry((String) pathModeContent[i]);
        entry.setFileMode((FileMode) pathModeContent[i + 1]);
        entry.setObjectId(
            FileMode.GITLINK.equals(entry.getRawMode())
                ? ObjectId.fromString("1234567890123456789012345678901234567890")
                : inserter.insert(3, ((String) pathModeContent[i + 2]).getBytes(UTF_8)));
        builder.add(entry);
      }
      builder.finish();
      commit(inserter, index.writeTree(inserter));
    }
  }

  private void commit(ObjectInserter inserter, ObjectId tree) throws IOException {
    CommitBuilder commit = new CommitBuilder();
    commit.setTreeId(tree);
    PersonIdent person = new PersonIdent("t", "t@example.org", 0, 0);
    commit.setAuthor(person);
    commit.setCommitter(person);
    ObjectId id = inserter.insert(commit);
    inserter.flush();
    RefUpdate update = repository.updateRef("HEAD");
    update.setNewObjectId(id);
    update.forceUpdate();
  }

  private String problem(String folder, String revision) {
    try {
      GitFolder.read(directory.resolve(folder), revision);
      throw new AssertionError("was read");
    } catch (InvalidInputException e) {
      return String.valueOf(e.getMessage());
    }
  }

  @Test
  void readsTheFilesOfAFolderThatIsNotCheckedOut() throws IOException {
    commit(
        "a/arm/activity.yaml",
        FileMode.REGULAR_FILE,
        "name: arm",
        "a/arm/component/.cache",
        FileMode.REGULAR_FILE,
        "",
        "a/arm/component/arm.py",
        FileMode.EXECUTABLE_FILE,
        "pass",
        "b/other",
        FileMode.REGULAR_FILE,
        "");
    FileTree files = GitFolder.read(directory.resolve("a/arm"), "HEAD");
    assertThat(files.paths()).containsExactly("activity.yaml", "component/arm.py");
    assertThat(files.text("activity.yaml")).contains("name: arm");
    assertThat(GitFolder.read(directory, "HEAD").paths()).contains("b/other");
  }

  /** Twelve objects that name 10^10 folders, or files that are hidden. */
  private void commitRepeatedFolders(String leaf) throws IOException {
    try (ObjectInserter inserter = repository.newObjectInserter()) {
      TreeFormatter last = new TreeFormatter();
      if (!leaf.isEmpty()) {
        last.append(leaf, FileMode.REGULAR_FILE, inserter.insert(3, new byte[0]));
      }
      ObjectId tree = inserter.insert(last);
      for (int level = 0; level < 10; level++) {
        TreeFormatter folders = new TreeFormatter();
        for (int i = 0; i < 10; i++) {
          folders.append("d" + i, FileMode.TREE, tree);
        }
        tree = inserter.insert(folders);
      }
      commit(inserter, tree);
    }
  }

  @Test
  @Timeout(30)
  void refusesFoldersThatRepeatEachOther() throws IOException {
    commitRepeatedFolders("");
    assertThat(problem("", "HEAD")).contains("more than 20000 files and folders");
    commitRepeatedFolders(".hidden");
    assertThat(problem("", "HEAD")).contains("more than 20000 files and folders");
  }

  @Test
  void refusesWhatTheRepositoryDoesNotHold() throws IOException {
    commit(
        "link/file",
        FileMode.SYMLINK,
        "/etc/passwd",
        "module/part",
        FileMode.GITLINK,
        "",
        "lfs/mesh.stl",
        FileMode.REGULAR_FILE,
        "version https://git-lfs.github.com/spec/v1\noid x");
    assertThat(problem("link", "HEAD")).contains("file is a link");
    assertThat(problem("module", "HEAD")).contains("part is a submodule");
    assertThat(problem("lfs", "HEAD")).contains("mesh.stl is kept in Git LFS");
    assertThat(problem("missing", "HEAD")).contains("missing does not exist at this revision");
    assertThat(problem("lfs/mesh.stl", "HEAD")).contains("does not exist at this revision");
  }

  @Test
  void refusesRevisionsThatDoNotExist() throws IOException {
    commit("a/file", FileMode.REGULAR_FILE, "");
    for (String revision : new String[] {"nowhere", "HEAD~1", "-x", "--upload-pack=x", "^^^{"}) {
      assertThat(problem("a", revision)).contains("is no revision of the repository");
    }
  }

  @Test
  @Timeout(20)
  void readsNoFileThatTheConfigurationIncludes(@TempDir Path other) throws IOException {
    commit("a/file", FileMode.REGULAR_FILE, "");
    Path config = directory.resolve(".git/config");
    String original = Files.readString(config);
    for (String header : new String[] {"[include]", "[INCLUDE]", "[include \"x\"]"}) {
      Files.writeString(config, original + header + "\n  path = /dev/zero\n");
      assertThat(problem("a", "HEAD")).contains("config").contains("includes other files");
    }

    // The working tree of a submodule or of `git worktree` names the folder of its repository.
    Path linked = Files.createDirectories(directory.resolve(".git/worktrees/w"));
    Files.writeString(linked.resolve("HEAD"), Files.readString(directory.resolve(".git/HEAD")));
    Files.writeString(linked.resolve("commondir"), "../..\n");
    Files.writeString(linked.resolve("gitdir"), other.resolve(".git") + "\n");
    Files.createDirectories(other.resolve("a"));
    Files.writeString(other.resolve(".git"), "gitdir: " + linked + "\n");
    assertThatThrownBy(() -> GitFolder.read(other.resolve("a"), "HEAD"))
        .hasMessageContaining("includes other files");
    Files.writeString(config, original);
    assertThat(GitFolder.read(other.resolve("a"), "HEAD").paths()).containsExactly("file");
  }

  @Test
  @Timeout(20)
  void refusesAConfigurationThatIsNoText() throws IOException {
    commit("a/file", FileMode.REGULAR_FILE, "");
    Path config = directory.resolve(".git/config");
    Files.delete(config);
    Files.createSymbolicLink(config, Path.of("/dev/zero"));
    assertThat(problem("a", "HEAD")).contains("is not a regular file");
    Files.delete(config);
    Files.writeString(config, "#".repeat((1 << 20) + 1));
    assertThat(problem("a", "HEAD")).contains("more than 1048576 bytes");
  }

  @Test
  void refusesAFolderOutsideOfARepository(@TempDir Path other) {
    assertThatThrownBy(() -> GitFolder.read(other, "HEAD"))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("is not in a Git repository");
  }
}
