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
 * A Java source of a test application in memory, identified by its path in the layout of the
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
   * The sources of component, adapter and harness, sorted by path.
   *
   * @throws CompilationException if one is not UTF-8 text
   */
  static List<JavaSource> of(TestApplication application) throws CompilationException {
    NavigableMap<String, JavaSource> sources = new TreeMap<>();
    FileTree files = application.activity().files();
    for (String folder : userFolders(application)) {
      FileTree inside = files.below(folder);
      for (String path : inside.paths()) {
        if (path.endsWith(".java")) {
          String layoutPath = ACTIVITY + withTrailingSlash(folder) + path;
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

  /** The user's source folders in the activity. */
  static List<String> userFolders(TestApplication application) {
    Component component = application.activity().profile().component();
    return Stream.of(component.sources(), component.adapter()).filter(Objects::nonNull).toList();
  }

  /**
   * The concrete test driver may be the user's own file in the activity; its errors are reported
   * with the path in the activity. Null if the source is generated.
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
          path + " is not UTF-8 text",
          List.of(new SourceDiagnostic(path, 0, 0, "not UTF-8 text; save it as UTF-8", generated)));
    }
  }

  /**
   * Files in the user's source folders that are not sources: resources, by path on the class path.
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

  private static String withTrailingSlash(String folder) {
    return folder.endsWith("/") ? folder : folder + "/";
  }
}
