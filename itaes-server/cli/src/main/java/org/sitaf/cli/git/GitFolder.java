package org.sitaf.cli.git;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.eclipse.jgit.errors.LargeObjectException;
import org.eclipse.jgit.errors.MissingObjectException;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectLoader;
import org.eclipse.jgit.treewalk.TreeWalk;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/**
 * Reads a folder at a revision of the Git repository that holds it. Only objects are read: no hook,
 * filter or other program runs, and nothing is written.
 */
public final class GitFolder {
  private static final String LFS = "version https://git-lfs.github.com/spec/";
  private static final int MAX_LFS_POINTER = 1024;

  /**
   * Maximum number of files and folders, also hidden ones. A few small tree objects that repeat
   * each other can name any number of folders without a file.
   */
  private static final int MAX_ENTRIES = 2 * ActivityArchive.MAX_FILES;

  private static final int MAX_DEPTH = 50;

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
  public static FileTree read(Path folder, String revision) {
    return new GitFolder(folder, revision).read();
  }

  private FileTree read() {
    try (FolderRepository repository = FolderRepository.open(folder)) {
      Map<String, byte[]> files = new HashMap<>();
      try (TreeWalk walk = new TreeWalk(repository.objects())) {
        enter(repository, walk);
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

  private void enter(FolderRepository repository, TreeWalk walk) throws IOException {
    ObjectId tree = repository.commit(revision).getTree();
    ObjectId found = repository.folderIn(tree);
    if (found == null) {
      throw invalid("the folder " + repository.path() + " does not exist at this revision");
    }
    walk.addTree(found);
  }

  private void read(TreeWalk walk, Map<String, byte[]> files) throws IOException {
    long size = 0;
    int entries = 0;
    while (walk.next()) {
      if (++entries > MAX_ENTRIES || walk.getDepth() > MAX_DEPTH) {
        throw invalid(
            "holds more than %d files and folders, or folders nested more than %d deep; name a folder with the activity only"
                .formatted(MAX_ENTRIES, MAX_DEPTH));
      }
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
}
