package org.sitaf.agent.spool;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.sitaf.agent.testing.OddTrees;
import org.sitaf.agent.testing.OrdinaryUser;

/** Deletes trees of any shape. */
@Timeout(300)
class FoldersTest {
  @TempDir private Path directory;

  @Test
  void deletesFoldersDeeperThanTheLongestPath() throws Exception {
    Path folder = Files.createDirectory(directory.resolve("deep"));
    OddTrees.createNestedFolders(folder, 3000);

    Folders.delete(folder);

    assertThat(folder).doesNotExist();
  }

  @Test
  void deletesALinkAndNotItsTarget() throws IOException {
    Path outside = Files.createDirectory(directory.resolve("outside"));
    Path file = Files.writeString(outside.resolve("file"), "untouched");
    Path folder = Files.createDirectory(directory.resolve("folder"));
    Files.createSymbolicLink(folder.resolve("link"), outside);

    Folders.delete(folder);
    Folders.delete(Files.createSymbolicLink(directory.resolve("link"), outside));

    assertThat(file).hasContent("untouched");
    assertThat(directory).isDirectoryNotContaining(path -> !path.equals(outside));
  }

  @Test
  void deletesUnreadableFoldersAsAnUnprivilegedUser() throws Exception {
    Path folder = OrdinaryUser.folder(directory);

    assertThat(OrdinaryUser.run(Deleting.class, folder.toString())).contains("gone");
  }

  /** Main program for an unprivileged user. */
  static final class Deleting {
    public static void main(String[] arguments) throws Exception {
      Path folder = Files.createDirectory(Path.of(arguments[0], "folder"));
      OddTrees.lock(folder);
      OddTrees.createNestedFolders(Files.createDirectory(folder.resolve("deep")), 400);
      Folders.delete(folder);
      System.out.println(Files.exists(folder) ? "there" : "gone");
    }
  }
}
