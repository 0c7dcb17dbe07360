package org.sitaf.agent.toolchain.cpp;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.cpp.inputs.InputCheck;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;

/** The sources of a C++ test application: component, adapter and harness. */
final class CppSources {
  /** Modification time of all sources, in seconds since 1970: the beginning of 1980. */
  static final long TIME = 315_532_800;

  private static final Set<String> UNITS = Set.of("cpp", "cc", "cxx", "c++", "C");

  private final TestApplication application;
  private final Path root;

  CppSources(Compilation compilation) {
    this.application = compilation.application();
    this.root = compilation.sources();
  }

  /**
   * A translation unit.
   *
   * @param path in the layout of the application
   */
  record Unit(String path, Path file, boolean ofHarness) {}

  /** All translation units; the harness first, because it takes longest. */
  List<Unit> units() {
    List<Unit> units = new ArrayList<>();
    for (String path : application.harness().paths()) {
      if (isUnit(path)) {
        units.add(unit("harness/" + path, true));
      }
    }
    FileTree files = application.activity().files();
    Component component = application.activity().profile().component();
    for (String folder : userFolders()) {
      if (component.cpp().cmake() != null && folder.equals(component.sources())) {
        // CMake compiles them.
        continue;
      }
      for (String path : files.below(folder).paths()) {
        if (isUnit(path)) {
          units.add(unit("activity/" + withTrailingSlash(folder) + path, false));
        }
      }
    }
    return units;
  }

  private Unit unit(String path, boolean ofHarness) {
    return new Unit(path, root.resolve(path), ofHarness);
  }

  /** The user's source folders in the activity. */
  private List<String> userFolders() {
    Component component = application.activity().profile().component();
    return Stream.of(component.adapter(), component.sources()).filter(Objects::nonNull).toList();
  }

  /** The include path. */
  List<Path> includeFolders() {
    List<Path> folders = new ArrayList<>();
    String entry = application.entryPoint();
    folders.add(root.resolve("harness").resolve(entry));
    folders.add(root.resolve("harness"));
    for (String folder : userFolders()) {
      folders.add(root.resolve("activity").resolve(folder));
    }
    String headers = application.activity().profile().component().headers();
    if (headers != null) {
      folders.add(root.resolve("activity").resolve(headers));
    }
    for (String include : application.activity().profile().component().cpp().includes()) {
      folders.add(root.resolve("activity").resolve(include));
    }
    return folders;
  }

  /** Checks inputs against the files of the application and the given search path. */
  InputCheck inputCheck(List<Path> folders, List<Path> known) {
    List<Path> all = new ArrayList<>(includeFolders());
    all.addAll(folders);
    return new InputCheck(application.harness(), application.activity().files(), root, all, known);
  }

  /**
   * Sets the modification time of each file to a value derived from its path. The time appears in
   * {@code __TIMESTAMP__}, and compilers treat two files of equal content and time as the same one
   * for {@code #pragma once}.
   */
  void setTimes() throws IOException {
    for (Map.Entry<String, FileTree> tree :
        Map.of("harness", application.harness(), "activity", application.activity().files())
            .entrySet()) {
      for (String path : tree.getValue().paths()) {
        String inLayout = tree.getKey() + "/" + path;
        Digest digest = new Digest();
        digest.add(inLayout);
        long seconds = Long.parseLong(digest.hexadecimal().substring(0, 7), 16);
        Files.setLastModifiedTime(
            root.resolve(inLayout), FileTime.from(TIME + seconds, TimeUnit.SECONDS));
      }
    }
  }

  /** Maps a path in compiler output to the user's view. */
  CompilerOutput.Place place(String printed) {
    Path path = Path.of(printed);
    Path absolute = path.isAbsolute() ? path.normalize() : root.resolve(path).normalize();
    if (!absolute.startsWith(root)) {
      return CompilerOutput.Place.ELSEWHERE;
    }
    String inLayout = root.relativize(absolute).toString();
    if (!inLayout.startsWith("harness/")) {
      return new CompilerOutput.Place(inLayout, false);
    }
    // The concrete test driver may be the user's own file in the activity.
    String kept =
        InterfaceTestApplicationGenerator.keptDriver(application.activity(), application.model());
    String editable =
        InterfaceTestApplicationGenerator.editableFile(application.activity(), application.model());
    boolean isKept =
        inLayout.equals("harness/" + editable) && application.activity().files().contains(kept);
    return isKept
        ? new CompilerOutput.Place("activity/" + kept, false)
        : new CompilerOutput.Place(inLayout, true);
  }

  private static boolean isUnit(String path) {
    return UNITS.contains(path.substring(path.lastIndexOf('.') + 1));
  }

  static String withTrailingSlash(String folder) {
    return folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
  }
}
