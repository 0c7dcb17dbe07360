package org.sitaf.agent.toolchain.cpp;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Stream;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;

/** The sources of a C++ test application: component, adapter and harness. */
final class CppSources {
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

  /** All translation units: the harness's first, since they take the longest. */
  List<Unit> units() {
    List<Unit> units = new ArrayList<>();
    for (String path : application.harness().paths()) {
      if (isUnit(path)) {
        units.add(unit("harness/" + path, true));
      }
    }
    FileTree files = application.activity().files();
    for (String folder : userFolders()) {
      for (String path : files.below(folder).paths()) {
        if (isUnit(path)) {
          units.add(unit("activity/" + withSlash(folder) + path, false));
        }
      }
    }
    return units;
  }

  private Unit unit(String path, boolean ofHarness) {
    return new Unit(path, root.resolve(path), ofHarness);
  }

  /** Folders of the activity with the user's sources. */
  private List<String> userFolders() {
    Component component = application.activity().profile().component();
    return Stream.of(component.adapter(), component.sources()).filter(Objects::nonNull).toList();
  }

  /** Where includes are looked for. */
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
    return folders;
  }

  /** Whatever a translation unit may include of the application, by path and content. */
  void addHeadersTo(Digest digest) {
    for (String path : application.harness().paths()) {
      if (!isUnit(path)) {
        digest.add(path);
        digest.add(application.harness().content(path).orElseThrow());
      }
    }
    FileTree files = application.activity().files();
    for (String path : files.paths()) {
      if (!isUnit(path) && inSources(path)) {
        digest.add(path);
        digest.add(files.content(path).orElseThrow());
      }
    }
  }

  private boolean inSources(String path) {
    List<String> folders = new ArrayList<>(userFolders());
    String headers = application.activity().profile().component().headers();
    if (headers != null) {
      folders.add(headers);
    }
    return folders.stream().anyMatch(folder -> path.startsWith(withSlash(folder)));
  }

  /** What a path of the compiler's means to the user. */
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
    // The concrete test driver may be the user's own, kept in the activity.
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

  static String withSlash(String folder) {
    return folder.isEmpty() || folder.endsWith("/") ? folder : folder + "/";
  }
}
