package org.sitaf.cli.compare;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.eclipse.jgit.errors.ConfigInvalidException;
import org.eclipse.jgit.errors.LargeObjectException;
import org.eclipse.jgit.errors.MissingObjectException;
import org.eclipse.jgit.errors.RevisionSyntaxException;
import org.eclipse.jgit.lib.Config;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectLoader;
import org.eclipse.jgit.lib.Repository;
import org.eclipse.jgit.storage.file.FileBasedConfig;
import org.eclipse.jgit.storage.file.FileRepositoryBuilder;
import org.eclipse.jgit.treewalk.TreeWalk;
import org.eclipse.jgit.util.FS;
import org.eclipse.jgit.util.SystemReader;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * Reads a folder at a revision of the Git repository that holds it. Only objects are read: no hook,
 * filter or other program runs, and nothing is written.
 */
final class GitFolder {
  private static final String LFS = "version https://git-lfs.github.com/spec/";
  private static final int MAX_LFS_POINTER = 1024;

  private final Path folder;
  private final String revision;
  private final String name;

  private GitFolder(Path folder, String revision) {
    this.folder = folder;
    this.revision = revision;
    this.name = folder + "@" + revision;
  }

  /**
   * The files of a folder without hidden files and folders.
   *
   * @param folder in the working tree; needs to exist at the revision only
   * @throws InvalidInputException if there is no repository, revision or folder, or if the folder
   *     holds something that is not a plain file
   */
  static FileTree read(Path folder, String revision) {
    return new GitFolder(folder, revision).read();
  }

  private FileTree read() {
    SystemReader.setInstance(new NoUserConfig());
    try (Repository repository = open()) {
      String path = pathIn(repository);
      ObjectId tree = tree(repository);
      Map<String, byte[]> files = new HashMap<>();
      try (TreeWalk walk = new TreeWalk(repository)) {
        enter(repository, walk, tree, path);
        walk.setRecursive(false);
        read(walk, files);
      }
      return FileTree.of(files);
    } catch (MissingObjectException e) {
      throw invalid(
          "an object is missing in the repository; fetch it completely: " + e.getMessage());
    } catch (LargeObjectException e) {
      throw invalid("holds a file that is too large: " + e.getMessage());
    } catch (IOException e) {
      throw invalid("cannot be read: " + e.getMessage());
    } catch (IllegalArgumentException e) {
      throw invalid(String.valueOf(e.getMessage()));
    }
  }

  private InvalidInputException invalid(String message) {
    return InvalidInputException.of(name, message);
  }

  private Repository open() throws IOException {
    Path existing = folder.toAbsolutePath().normalize();
    while (existing != null && !Files.isDirectory(existing)) {
      existing = existing.getParent();
    }
    FileRepositoryBuilder builder = new FileRepositoryBuilder().setMustExist(true);
    if (existing != null) {
      builder.findGitDir(existing.toRealPath().toFile());
    }
    if (builder.getGitDir() == null) {
      throw invalid(folder + " is not in a Git repository; without one, name two folders");
    }
    return builder.build();
  }

  /** The folder relative to the working tree; empty for the whole tree. */
  private String pathIn(Repository repository) throws IOException {
    if (repository.isBare()) {
      throw invalid("the repository has no working tree; clone it");
    }
    Path absolute = folder.toAbsolutePath().normalize();
    Path existing = absolute;
    while (!Files.exists(existing) && existing.getParent() != null) {
      existing = existing.getParent();
    }
    Path real = existing.toRealPath().resolve(existing.relativize(absolute)).normalize();
    Path root = repository.getWorkTree().toPath().toRealPath();
    if (!real.startsWith(root)) {
      throw invalid(folder + " is not in the working tree " + root);
    }
    return root.relativize(real).toString().replace('\\', '/');
  }

  private ObjectId tree(Repository repository) throws IOException {
    ObjectId tree = null;
    try {
      tree = repository.resolve(revision + "^{tree}");
    } catch (RevisionSyntaxException e) {
      // Reported below.
    }
    if (tree == null) {
      throw invalid(
          "'"
              + revision
              + "' is no revision of the repository "
              + repository.getWorkTree()
              + "; 'git log' lists them");
    }
    return tree;
  }

  private void enter(Repository repository, TreeWalk walk, ObjectId tree, String path)
      throws IOException {
    if (path.isEmpty()) {
      walk.addTree(tree);
      return;
    }
    try (TreeWalk found = TreeWalk.forPath(repository, path, tree)) {
      if (found == null || !FileMode.TREE.equals(found.getRawMode(0))) {
        throw invalid("the folder " + path + " does not exist at this revision");
      }
      walk.addTree(found.getObjectId(0));
    }
  }

  private void read(TreeWalk walk, Map<String, byte[]> files) throws IOException {
    long size = 0;
    while (walk.next()) {
      String path = walk.getPathString();
      int mode = walk.getRawMode(0);
      if (path.startsWith(".") || path.contains("/.")) {
        continue;
      }
      if (FileMode.TREE.equals(mode)) {
        walk.enterSubtree();
        continue;
      }
      if (FileMode.SYMLINK.equals(mode)) {
        throw invalid(path + " is a link; copy the file into the activity");
      }
      if (FileMode.GITLINK.equals(mode)) {
        throw invalid(
            path + " is a submodule, whose files the repository does not hold; name a folder");
      }
      ObjectLoader file = walk.getObjectReader().open(walk.getObjectId(0));
      size += file.getSize();
      if (size > ActivityArchive.MAX_SIZE || files.size() >= ActivityArchive.MAX_FILES) {
        throw invalid(
            "holds more than %d files or %d MiB; remove files that the test does not need"
                .formatted(ActivityArchive.MAX_FILES, ActivityArchive.MAX_SIZE >> 20));
      }
      byte[] content = file.getBytes((int) ActivityArchive.MAX_SIZE);
      if (isLfsPointer(content)) {
        throw invalid(
            path
                + " is kept in Git LFS, which is not read; check the revision out and name its"
                + " folder");
      }
      files.put(path, content);
    }
  }

  private static boolean isLfsPointer(byte[] content) {
    return content.length <= MAX_LFS_POINTER
        && new String(content, java.nio.charset.StandardCharsets.UTF_8).startsWith(LFS);
  }

  /** Reads no configuration of the machine or the user, and runs no program to find it. */
  private static final class NoUserConfig extends SystemReader.Delegate {
    NoUserConfig() {
      super(SystemReader.getInstance());
    }

    @Override
    public FileBasedConfig openSystemConfig(Config parent, FS fs) {
      return empty(parent, fs);
    }

    @Override
    public FileBasedConfig openUserConfig(Config parent, FS fs) {
      return empty(parent, fs);
    }

    @Override
    public FileBasedConfig openJGitConfig(Config parent, FS fs) {
      return empty(parent, fs);
    }

    private static FileBasedConfig empty(Config parent, FS fs) {
      return new FileBasedConfig(parent, null, fs) {
        @Override
        public void load() throws IOException, ConfigInvalidException {
          // There is no file.
        }

        @Override
        public boolean isOutdated() {
          return false;
        }
      };
    }
  }
}
