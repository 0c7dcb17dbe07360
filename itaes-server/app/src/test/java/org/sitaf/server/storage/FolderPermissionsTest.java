package org.sitaf.server.storage;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class FolderPermissionsTest {
  @TempDir private Path temporary = Path.of("");

  @Test
  void newFolderIsPrivate() throws IOException {
    Path folder = temporary.resolve("a/b");
    FolderPermissions.secure(folder);
    assertThat(mode(folder)).isEqualTo("rwx------");
  }

  @Test
  void existingFolderIsRestrictedWithItsFiles() throws IOException {
    Path database = Files.writeString(temporary.resolve("database.mv.db"), "sessions");
    Path logs = Files.createDirectory(temporary.resolve("logs"));
    Path log = Files.writeString(logs.resolve("x.log"), "log");
    open(temporary, "rwxr-xr-x");
    open(database, "rw-r--r--");
    open(logs, "rwxr-xr-x");
    open(log, "rw-rw-rw-");
    FolderPermissions.secure(temporary);
    assertThat(mode(temporary)).isEqualTo("rwx------");
    assertThat(mode(database)).isEqualTo("rw-------");
    assertThat(mode(logs)).isEqualTo("rwx------");
    assertThat(mode(log)).isEqualTo("rw-------");
  }

  @Test
  void folderWithForeignFilesIsNotRestricted() throws IOException {
    Files.writeString(temporary.resolve("database.mv.db"), "sessions");
    Files.writeString(temporary.resolve("letter.txt"), "foreign");
    open(temporary, "rwxr-xr-x");
    FolderPermissions.secure(temporary);
    assertThat(mode(temporary)).isEqualTo("rwxr-xr-x");
    assertThat(mode(temporary.resolve("database.mv.db"))).isEqualTo("rw-------");
  }

  private static void open(Path path, String mode) throws IOException {
    Files.setPosixFilePermissions(path, PosixFilePermissions.fromString(mode));
  }

  private static String mode(Path path) throws IOException {
    return PosixFilePermissions.toString(Files.getPosixFilePermissions(path));
  }
}
