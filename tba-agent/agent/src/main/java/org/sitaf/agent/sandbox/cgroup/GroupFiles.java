package org.sitaf.agent.sandbox.cgroup;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryIteratorException;
import java.nio.file.DirectoryStream;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * The kernel's files of control groups. Creating or removing a folder creates or removes a group.
 */
class GroupFiles {
  void create(Path group) throws IOException {
    Files.createDirectory(group);
  }

  void remove(Path group) throws IOException {
    Files.deleteIfExists(group);
  }

  void write(Path file, String value) throws IOException {
    Files.writeString(file, value);
  }

  List<String> lines(Path file) throws IOException {
    return Files.readAllLines(file, StandardCharsets.UTF_8);
  }

  /** Writes a file that some kernels lack; returns whether it was written. */
  final boolean tryWrite(Path file, String value) {
    try {
      if (Files.exists(file)) {
        write(file, value);
        return true;
      }
    } catch (IOException e) {
      // Treated like a missing file.
    }
    return false;
  }

  /** The number in the line {@code NAME NUMBER}; 0 without such a line. */
  final long number(Path file, String name) {
    try {
      for (String line : lines(file)) {
        if (line.startsWith(name + " ")) {
          return Long.parseLong(line.substring(name.length() + 1).strip());
        }
      }
    } catch (IOException | NumberFormatException e) {
      // The group no longer exists.
    }
    return 0;
  }

  /** The processes of a group, without those of its subgroups. */
  final List<Long> members(Path group) {
    try {
      List<Long> members = new ArrayList<>();
      for (String line : lines(group.resolve(ControlGroup.MEMBERS))) {
        members.add(Long.parseLong(line.strip()));
      }
      return members;
    } catch (IOException | NumberFormatException e) {
      return List.of();
    }
  }

  /** The subgroups of a group. */
  final List<Path> subgroups(Path group) {
    List<Path> found = new ArrayList<>();
    try (DirectoryStream<Path> entries = Files.newDirectoryStream(group)) {
      for (Path entry : entries) {
        if (Files.isDirectory(entry, LinkOption.NOFOLLOW_LINKS)) {
          found.add(entry);
        }
      }
    } catch (IOException | DirectoryIteratorException e) {
      return found;
    }
    return found;
  }
}
