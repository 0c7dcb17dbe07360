package org.sitaf.agent.toolchain.cpp.cmake;

import com.google.gson.JsonArray;
import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.sitaf.agent.spool.LeftFiles;
import org.sitaf.agent.toolchain.CompilationException;

/**
 * CMake's file API (cmake-file-api(7)): the replies about the program that uses the component's
 * target. The project could write these files, too, so they are read as untrusted; their flags
 * reach only tools in the sandbox.
 *
 * @param folder CMake's build folder
 * @param sources the application's files
 * @param tools files that SITAF gave CMake
 */
record FileApi(Path folder, Path sources, Path tools) {
  private static final String QUERY =
      "{\"requests\":[{\"kind\":\"codemodel\",\"version\":2},{\"kind\":\"cmakeFiles\",\"version\":1}]}";
  private static final Path API = Path.of(".cmake", "api", "v1");

  /** Parsed JSON takes some fifty times as much memory as its text. */
  private static final int MAX_REPLY_BYTES = 2 << 20;

  private static final int MAX_DEPENDENCY_BYTES = 1 << 20;
  private static final int MAX_FILES = 20_000;
  private static final int MAX_OPENED = 50_000;

  /** Each is copied to the output. */
  private static final int MAX_SHARED = 200;

  private static final long MAX_SHARED_BYTES = 512L << 20;
  private static final int DEFAULT_STANDARD = 17;

  /** Options that SITAF chooses itself. */
  private static final Pattern OWN_OPTION =
      Pattern.compile("-(O.*|g[0-9]?|std=.*|fPI[CE]|DNDEBUG|W.*|w|f.*-prefix-map=.*|fsanitize.*)");

  private static final Pattern SHARED = Pattern.compile(".+\\.so(\\.[0-9]+)*");
  private static final String BROKEN = "cmake's reply about the project cannot be read: ";

  /** Requests the replies, before CMake runs. */
  static void request(Path folder) throws IOException {
    Path client = folder.resolve(API).resolve("query").resolve("client-sitaf");
    Files.createDirectories(client);
    Files.writeString(client.resolve("query.json"), QUERY);
  }

  /**
   * Reads the replies and the compilers' dependency files.
   *
   * @throws CompilationException if the project left other files than CMake writes
   */
  LinkedTarget target(long startMillis, String warnings) throws CompilationException {
    try {
      JsonObject program = reply("target-sitaf_probe-");
      JsonArray groups = array(program, "compileGroups");
      JsonObject group = groups.isEmpty() ? new JsonObject() : groups.get(0).getAsJsonObject();
      return new LinkedTarget(
          folder,
          compileFlags(group),
          linkFlags(program),
          sharedLibraries(),
          standard(group),
          opened(),
          startMillis,
          warnings);
    } catch (IOException | RuntimeException e) {
      // For a member that is missing or of another kind, Gson throws various exceptions.
      throw new CompilationException(BROKEN + e.getMessage(), List.of());
    }
  }

  private JsonObject reply(String prefix) throws IOException {
    Path replies = folder.resolve(API).resolve("reply");
    List<Path> found =
        LeftFiles.in(replies, path -> path.getFileName().toString().startsWith(prefix), MAX_FILES);
    if (found.size() != 1) {
      throw new IOException("there are " + found.size() + " files " + prefix + "*.json");
    }
    return JsonParser.parseString(text(found.get(0), MAX_REPLY_BYTES)).getAsJsonObject();
  }

  private static String text(Path file, int maxBytes) throws IOException {
    return new String(LeftFiles.read(file, maxBytes), StandardCharsets.UTF_8);
  }

  private static JsonArray array(JsonObject object, String name) {
    JsonElement found = object.get(name);
    return found == null ? new JsonArray() : found.getAsJsonArray();
  }

  private static List<String> compileFlags(JsonObject group) {
    List<String> flags = new ArrayList<>();
    for (JsonElement include : array(group, "includes")) {
      JsonObject entry = include.getAsJsonObject();
      boolean system = entry.has("isSystem") && entry.get("isSystem").getAsBoolean();
      flags.add(system ? "-isystem" : "-I");
      flags.add(entry.get("path").getAsString());
    }
    for (JsonElement define : array(group, "defines")) {
      flags.add("-D" + define.getAsJsonObject().get("define").getAsString());
    }
    for (JsonElement fragment : array(group, "compileCommandFragments")) {
      for (String word : words(fragment)) {
        if (!OWN_OPTION.matcher(word).matches()) {
          flags.add(word);
        }
      }
    }
    return flags;
  }

  private static List<String> words(JsonElement fragment) {
    String text = fragment.getAsJsonObject().get("fragment").getAsString();
    return List.of(text.strip().split("\\s+")).stream().filter(word -> !word.isEmpty()).toList();
  }

  private List<String> linkFlags(JsonObject program) {
    List<String> flags = new ArrayList<>();
    JsonElement link = program.get("link");
    if (link == null) {
      return flags;
    }
    for (JsonElement fragment : array(link.getAsJsonObject(), "commandFragments")) {
      if (!fragment.getAsJsonObject().get("role").getAsString().equals("libraries")) {
        continue;
      }
      for (String word : words(fragment)) {
        // The project's shared libraries are copied next to the program.
        if (!word.startsWith("-Wl,-rpath")) {
          flags.add(
              word.startsWith("-") || word.startsWith("/")
                  ? word
                  : folder.resolve(word).toString());
        }
      }
    }
    return flags;
  }

  private static int standard(JsonObject group) {
    JsonElement standard = group.get("languageStandard");
    if (standard == null) {
      return DEFAULT_STANDARD;
    }
    String digits = standard.getAsJsonObject().get("standard").getAsString();
    return Set.of("11", "14", "17", "20", "23").contains(digits)
        ? Integer.parseInt(digits)
        : DEFAULT_STANDARD;
  }

  private List<Path> sharedLibraries() throws IOException {
    List<Path> found =
        LeftFiles.in(
            folder, path -> SHARED.matcher(path.getFileName().toString()).matches(), MAX_SHARED);
    long bytes = 0;
    for (Path library : found) {
      bytes += Files.size(library);
    }
    if (bytes > MAX_SHARED_BYTES) {
      throw new IOException(
          "the shared libraries have more than " + (MAX_SHARED_BYTES >> 20) + " MiB");
    }
    return found;
  }

  /** Files outside of the application and of the build folder. */
  private List<String> opened() throws IOException {
    Set<String> opened = new TreeSet<>();
    for (JsonElement input : array(reply("cmakeFiles-"), "inputs")) {
      addOpened(input.getAsJsonObject().get("path").getAsString(), opened);
    }
    for (Path file : LeftFiles.in(folder, path -> path.toString().endsWith(".o.d"), MAX_FILES)) {
      String text = text(file, MAX_DEPENDENCY_BYTES);
      StringTokenizer words = new StringTokenizer(text.substring(text.indexOf(':') + 1));
      while (words.hasMoreTokens()) {
        addOpened(words.nextToken(), opened);
      }
    }
    return List.copyOf(opened);
  }

  private void addOpened(String word, Set<String> opened) throws IOException {
    try {
      Path path = Path.of(word).normalize();
      boolean ofBuild = List.of(folder, sources, tools).stream().anyMatch(path::startsWith);
      if (path.isAbsolute() && !ofBuild) {
        opened.add(word);
        if (opened.size() > MAX_OPENED) {
          throw new IOException("the project opened more than " + MAX_OPENED + " files");
        }
      }
    } catch (InvalidPathException e) {
      // No file has this name.
    }
  }
}
