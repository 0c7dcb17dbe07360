package org.sitaf.core.activity;

import java.util.List;
import java.util.Objects;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.ros.RosNode;
import org.sitaf.core.diagnostic.Diagnostics;

/** Checks before a build that the files in a profile and the component's class exist. */
final class ComponentFiles {
  private static final Pattern JAVA_CLASS =
      Pattern.compile("[A-Za-z_$][A-Za-z0-9_$]*(\\.[A-Za-z_$][A-Za-z0-9_$]*)*");

  /** A hint for missing adapters. */
  private static final String SKELETON =
      "; ./sitaf harness ACTIVITY_DIR --adapter generates a skeleton";

  private ComponentFiles() {}

  static void verify(
      ActivityProfile profile, FileTree files, String file, Diagnostics diagnostics) {
    verify(profile.component(), "component", files, file, diagnostics);
    if (profile.ros() != null) {
      rosNode(profile.component(), profile.ros(), files, file, diagnostics);
    }
    if (profile.reference() != null) {
      verify(profile.reference(), "reference", files, file, diagnostics);
    }
    profile.libraries().forEach(l -> existing(l, "libraries", files, file, diagnostics));
    profile.idlIncludes().forEach(f -> folder(f, "idl_includes", files, file, diagnostics));
  }

  private static void verify(
      Component component, String entry, FileTree files, String file, Diagnostics diagnostics) {
    folder(component.sources(), entry + ".sources", files, file, diagnostics);
    adapter(component, entry, files, file, diagnostics);
    folder(component.headers(), entry + ".headers", files, file, diagnostics);
    component
        .cpp()
        .includes()
        .forEach(include -> folder(include, entry + ".includes", files, file, diagnostics));
    if (component.cpp().cmake() != null) {
      cmakeProject(component, entry, files, file, diagnostics);
    }
    existing(component.library(), entry + ".library", files, file, diagnostics);
    existing(component.profile(), entry + ".profile", files, file, diagnostics);
    if (component.language() == Language.JAVA
        && component.sources() != null
        && !component.className().isEmpty()) {
      javaClass(component, entry, files, file, diagnostics);
    }
  }

  private static void cmakeProject(
      Component component, String entry, FileTree files, String file, Diagnostics diagnostics) {
    String folder = Objects.requireNonNullElse(component.sources(), "");
    FileTree project = files.below(folder);
    if (!project.paths().isEmpty() && !project.contains("CMakeLists.txt")) {
      diagnostics.error(
          file,
          0,
          entry + ".cmake.project",
          "'" + folder + "' holds no CMakeLists.txt; name the top folder of a CMake project");
    }
  }

  private static void rosNode(
      Component component, RosNode node, FileTree files, String file, Diagnostics diagnostics) {
    String folder = Objects.requireNonNullElse(component.sources(), "");
    FileTree sources = files.below(folder);
    if (sources.paths().isEmpty()) {
      return;
    }
    if (!sources.contains("package.xml")) {
      diagnostics.error(
          file,
          0,
          "component.sources",
          "'" + folder + "' holds no package.xml; name the folder of a ROS 2 package");
    }
    String entry = node.entry();
    boolean isFile = node.isMain() && (node.isCpp() || entry.endsWith(".py"));
    String module = entry.substring(0, Math.max(0, entry.indexOf(':')));
    if (module.isEmpty()) {
      module = entry.contains(".") ? entry.substring(0, entry.lastIndexOf('.')) : "";
    }
    String path = module.replace('.', '/');
    boolean there =
        isFile
            ? sources.contains(entry)
            // The sources of a C++ class are found when they are compiled.
            : node.isCpp()
                || module.isEmpty()
                || sources.contains(path + ".py")
                || sources.contains(path + "/__init__.py");
    if (!there) {
      diagnostics.error(
          file,
          0,
          node.isMain() ? "component.main" : "component.class",
          (isFile ? "'" + entry + "'" : "the module " + module + " (" + path + ".py)")
              + " does not exist below '"
              + folder
              + "'");
    }
    if (node.parameterFile() != null) {
      existing(node.parameterFile(), "component.parameters", files, file, diagnostics);
    }
  }

  private static void javaClass(
      Component component, String entry, FileTree files, String file, Diagnostics diagnostics) {
    String className = component.className();
    String sources = Objects.requireNonNull(component.sources());
    if (!JAVA_CLASS.matcher(className).matches()) {
      diagnostics.error(
          file, 0, entry + ".class", "'" + className + "' is not the qualified name of a class");
      return;
    }
    // With an adapter, the class is part of the adapter.
    FileTree all =
        component.adapter() == null
            ? files.below(sources)
            : files.below(sources).with("adapter", files.below(component.adapter()));
    List<String> javaFiles = all.paths().stream().filter(p -> p.endsWith(".java")).toList();
    String expected = className.replace('.', '/') + ".java";
    String simple = className.substring(className.lastIndexOf('.') + 1);
    Pattern declaration =
        Pattern.compile("\\b(class|record|enum)\\s+" + Pattern.quote(simple) + "\\b");
    boolean declared =
        javaFiles.contains(expected)
            || javaFiles.stream()
                .map(p -> all.text(p).orElseThrow())
                .anyMatch(text -> declaration.matcher(text).find());
    if (!declared) {
      diagnostics.error(
          file,
          0,
          entry + ".class",
          "no source below '"
              + sources
              + (component.adapter() == null ? "" : "' and '" + component.adapter())
              + "' declares "
              + className
              + "; expected "
              + expected
              + (javaFiles.isEmpty() ? ", but there is no .java file" : ", found " + javaFiles)
              + (component.adapter() == null ? "" : SKELETON));
    }
  }

  private static void adapter(
      Component component, String entry, FileTree files, String file, Diagnostics diagnostics) {
    String folder = component.adapter();
    if (folder == null) {
      return;
    }
    if (files.below(folder).paths().isEmpty()) {
      diagnostics.error(
          file,
          0,
          entry + ".adapter",
          "the activity has no file below '" + folder + "'" + SKELETON);
    } else if (component.language() == Language.PYTHON) {
      pythonModule(component, entry, files, file, diagnostics);
    }
  }

  /** The module of the class may be part of the adapter or of the component. */
  private static void pythonModule(
      Component component, String entry, FileTree files, String file, Diagnostics diagnostics) {
    String className = component.className();
    int dot = className.lastIndexOf('.');
    if (dot < 0 || component.library() != null) {
      return;
    }
    String module = className.substring(0, dot).replace('.', '/');
    boolean there =
        Stream.of(component.adapter(), component.sources())
            .filter(Objects::nonNull)
            .map(files::below)
            .anyMatch(f -> f.contains(module + ".py") || f.contains(module + "/__init__.py"));
    if (!there) {
      diagnostics.error(
          file,
          0,
          entry + ".class",
          module + ".py does not exist below '" + component.adapter() + "'" + SKELETON);
    }
  }

  private static void folder(
      @org.jspecify.annotations.Nullable String path,
      String entry,
      FileTree files,
      String file,
      Diagnostics diagnostics) {
    if (path != null && files.below(path).paths().isEmpty()) {
      diagnostics.error(file, 0, entry, "the activity has no file below '" + path + "'");
    }
  }

  private static void existing(
      @org.jspecify.annotations.Nullable String path,
      String entry,
      FileTree files,
      String file,
      Diagnostics diagnostics) {
    if (path != null && !files.contains(path) && files.below(path).paths().isEmpty()) {
      diagnostics.error(file, 0, entry, "'" + path + "' does not exist in the activity");
    }
  }
}
