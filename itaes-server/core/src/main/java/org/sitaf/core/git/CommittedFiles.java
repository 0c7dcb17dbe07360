package org.sitaf.core.git;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import org.eclipse.jgit.errors.LargeObjectException;
import org.eclipse.jgit.errors.MissingObjectException;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectLoader;
import org.eclipse.jgit.lib.ObjectReader;
import org.eclipse.jgit.treewalk.TreeWalk;
import org.sitaf.core.activity.ActivityArchive;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;

/** Reads the files of a Git tree. Only objects are read: no filter runs, and nothing is written. */
public final class CommittedFiles {
  private static final String LFS = "version https://git-lfs.github.com/spec/";
  private static final int MAX_LFS_POINTER = 1024;

  /**
   * Maximum number of files and folders, also hidden ones. A few small tree objects that repeat
   * each other can name any number of folders without a file.
   */
  private static final int MAX_ENTRIES = 2 * ActivityArchive.MAX_FILES;

  private static final int MAX_DEPTH = 50;

  private final String name;

  private CommittedFiles(String name) {
    this.name = name;
  }

  /**
   * The files of a tree without hidden files and folders.
   *
   * @param name of the tree, for messages
   * @throws InvalidInputException if the tree holds something that is not a plain file, or too much
   */
  public static FileTree read(ObjectReader objects, ObjectId tree, String name) {
    return new CommittedFiles(name).read(objects, tree);
  }

  private FileTree read(ObjectReader objects, ObjectId tree) {
    Map<String, byte[]> files = new HashMap<>();
    try (TreeWalk walk = new TreeWalk(objects)) {
      walk.addTree(tree);
      walk.setRecursive(false);
      read(walk, files);
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
        && new String(content, StandardCharsets.UTF_8).startsWith(LFS);
  }

  private InvalidInputException invalid(String message) {
    return InvalidInputException.of(name, message);
  }
}
