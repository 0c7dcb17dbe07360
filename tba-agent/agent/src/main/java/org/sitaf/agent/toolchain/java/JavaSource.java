package org.sitaf.agent.toolchain.java;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.InterfaceTestApplicationGenerator;
import org.sitaf.core.harness.TestApplication;

/**
 * A Java source of a test application, in memory, known by its path in the layout of the
 * application.
 */
final class JavaSource {
  private static final String ACTIVITY = "activity/";

  private final String path;
  private final String text;
  private final boolean generated;

  private JavaSource(String path, String text, boolean generated) {
    this.path = path;
    this.text = text;
    this.generated = generated;
  }

  /**
   * The sources of component, adapter and harness, in the order of their paths.
   *
   * @throws CompilationException if one is not text in UTF-8
   */
  static List<JavaSource> of(TestApplication application) throws CompilationException {
    NavigableMap<String, JavaSource> sources = new TreeMap<>();
    FileTree files = application.activity().files();
    for (String folder : userFolders(application)) {
      FileTree inside = files.below(folder);
      for (String path : inside.paths()) {
        if (path.endsWith(".java")) {
          String layoutPath = ACTIVITY + withSlash(folder) + path;
          sources.put(layoutPath, decode(layoutPath, inside.content(path).orElseThrow(), false));
        }
      }
    }
    for (String path : application.harness().paths()) {
      if (path.endsWith(".java")) {
        byte[] content = application.harness().content(path).orElseThrow();
        String kept = userFileOf(path, application);
        String layoutPath = kept == null ? "harness/" + path : kept;
        sources.put(layoutPath, decode(layoutPath, content, kept == null));
      }
    }
    return List.copyOf(sources.values());
  }

  /** Folders of the activity that hold the user's sources. */
  static List<String> userFolders(TestApplication application) {
    Component component = application.activity().profile().component();
    return Stream.of(component.sources(), component.adapter()).filter(Objects::nonNull).toList();
  }

  /**
   * The concrete test driver may be the user's own, kept in the activity: it goes by the user's
   * path, so that an error in it is told where the user can mend it. Null where the source is
   * generated.
   */
  private static @Nullable String userFileOf(String harnessPath, TestApplication application) {
    String kept =
        InterfaceTestApplicationGenerator.keptDriver(application.activity(), application.model());
    boolean isKept =
        harnessPath.equals(
                InterfaceTestApplicationGenerator.editableFile(
                    application.activity(), application.model()))
            && application.activity().files().contains(kept);
    return isKept ? ACTIVITY + kept : null;
  }

  private static JavaSource decode(String path, byte[] content, boolean generated)
      throws CompilationException {
    try {
      String text = StandardCharsets.UTF_8.newDecoder().decode(ByteBuffer.wrap(content)).toString();
      return new JavaSource(path, text, generated);
    } catch (CharacterCodingException e) {
      throw new CompilationException(
          path + " is not text in UTF-8",
          List.of(new SourceDiagnostic(path, 0, 0, "not text in UTF-8; save it so", generated)));
    }
  }

  /**
   * Files beside the user's sources that are no sources: resources of the component, by path in the
   * class path.
   */
  static Map<String, byte[]> resources(TestApplication application) {
    Map<String, byte[]> resources = new TreeMap<>();
    for (String folder : userFolders(application)) {
      FileTree inside = application.activity().files().below(folder);
      for (String path : inside.paths()) {
        if (!path.endsWith(".java")) {
          resources.put(path, inside.content(path).orElseThrow());
        }
      }
    }
    return resources;
  }

  String path() {
    return path;
  }

  boolean generated() {
    return generated;
  }

  String text() {
    return text;
  }

  private static String withSlash(String folder) {
    return folder.endsWith("/") ? folder : folder + "/";
  }
}
