package org.sitaf.cli.git;

import java.io.IOException;
import java.nio.file.Path;
import org.eclipse.jgit.errors.MissingObjectException;
import org.eclipse.jgit.lib.ObjectId;
import org.eclipse.jgit.lib.ObjectReader;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.git.CommittedFiles;

/** Reads a folder at a revision of the Git repository that holds it. */
public final class GitFolder {
  private GitFolder() {}

  /**
   * The files of a folder without hidden files and folders.
   *
   * @param folder in the working tree; needs to exist at the revision only
   * @throws InvalidInputException if there is no repository, revision or folder, or if the folder
   *     holds something that is not a plain file
   */
  public static FileTree read(Path folder, String revision) {
    String name = folder + "@" + revision;
    try (FolderRepository repository = FolderRepository.open(folder);
        ObjectReader objects = repository.objects().newObjectReader()) {
      ObjectId tree = repository.folderIn(repository.commit(revision).getTree());
      if (tree == null) {
        throw InvalidInputException.of(
            name, "the folder " + repository.path() + " does not exist at this revision");
      }
      return CommittedFiles.read(objects, tree, name);
    } catch (MissingObjectException e) {
      throw InvalidInputException.of(
          name, "an object is missing in the repository; fetch it completely: " + e.getMessage());
    } catch (IOException e) {
      throw InvalidInputException.of(name, "cannot be read: " + e.getMessage());
    }
  }
}
