package org.sitaf.cli.git;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.jgit.errors.IncorrectObjectTypeException;
import org.eclipse.jgit.errors.RevisionSyntaxException;
import org.eclipse.jgit.lib.FileMode;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.Repository;
import org.eclipse.jgit.revwalk.RevCommit;
import org.eclipse.jgit.revwalk.RevWalk;
import org.eclipse.jgit.storage.file.FileRepositoryBuilder;
import org.eclipse.jgit.treewalk.TreeWalk;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.git.NoUserConfiguration;

/**
 * The Git repository that holds a folder. Only objects are read: no hook, filter or other program
 * runs, no configuration of the user is read, that of the repository refers to no other files, and
 * nothing is written.
 */
final class FolderRepository implements AutoCloseable {
  private final Path folder;
  private final Repository repository;
  private final String path;

  private FolderRepository(Path folder, Repository repository, String path) {
    this.folder = folder;
    this.repository = repository;
    this.path = path;
  }

  /**
   * Opens the repository.
   *
   * @param folder in the working tree; needs not exist there
   * @throws InvalidInputException if no working tree of a repository holds the folder
   */
  static FolderRepository open(Path folder) throws IOException {
    NoUserConfiguration.install();
    Path absolute = folder.toAbsolutePath().normalize();
    Path existing = absolute;
    while (!Files.isDirectory(existing) && existing.getParent() != null) {
      existing = existing.getParent();
    }
    FileRepositoryBuilder builder = new FileRepositoryBuilder().setMustExist(true);
    builder.findGitDir(existing.toRealPath().toFile());
    if (builder.getGitDir() == null) {
      throw InvalidInputException.of(
          folder.toString(), "is not in a Git repository; without one, name two folders");
    }
    RepositoryConfiguration.requireWithoutIncludes(builder.getGitDir().toPath());
    Repository repository = builder.build();
    try {
      if (repository.isBare()) {
        throw InvalidInputException.of(
            folder.toString(), "the repository has no working tree; clone it");
      }
      Path real = existing.toRealPath().resolve(existing.relativize(absolute)).normalize();
      Path root = repository.getWorkTree().toPath().toRealPath();
      if (!real.startsWith(root)) {
        throw InvalidInputException.of(folder.toString(), "is not in the working tree " + root);
      }
      return new FolderRepository(
          folder, repository, root.relativize(real).toString().replace('\\', '/'));
    } catch (IOException | RuntimeException e) {
      repository.close();
      throw e;
    }
  }

  /** The folder relative to the working tree; empty for the whole tree. */
  String path() {
    return path;
  }

  Repository objects() {
    return repository;
  }

  /**
   * Finds a commit.
   *
   * @throws InvalidInputException if the revision names none
   */
  RevCommit commit(String revision) throws IOException {
    ObjectId found = null;
    try {
      found = repository.resolve(revision + "^{commit}");
    } catch (RevisionSyntaxException | IncorrectObjectTypeException e) {
      // Reported below.
    }
    if (found == null) {
      throw InvalidInputException.of(
          folder + "@" + revision,
          "'"
              + revision
              + "' is no revision of the repository "
              + repository.getWorkTree()
              + "; 'git log' lists them");
    }
    try (RevWalk walk = new RevWalk(repository)) {
      return walk.parseCommit(found);
    }
  }

  /** The folder in the tree of a commit; null if it does not exist there. */
  @Nullable ObjectId folderIn(ObjectId tree) throws IOException {
    if (path.isEmpty()) {
      return tree;
    }
    try (TreeWalk found = TreeWalk.forPath(repository, path, tree)) {
      return found == null || !FileMode.TREE.equals(found.getRawMode(0))
          ? null
          : found.getObjectId(0);
    }
  }

  @Override
  public void close() {
    repository.close();
  }
}
