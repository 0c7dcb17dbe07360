import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Random edits and their reversal. */
final class Edits {
  private static final Pattern NUMBER = Pattern.compile("(?<![\\w.])\\d+(?![\\w.])");

  /** Names in include directives, existing or not, with further content of such files. */
  private static final Map<String, String> ASKED =
      Map.of(
          "config.hpp", "#pragma once\nenum { CONFIG = 30 };\n",
          "right.hpp", "#pragma once\n#define RIGHT 31\n",
          "deep.hpp", "#pragma once\n#define DEEP 32\n",
          "chosen.hpp", "#pragma once\n#define CHOSEN 33\n",
          "option.hpp", "#pragma once\n#define OPTION 34\n",
          "only-asked.hpp", "#pragma once\n",
          "more/inner.hpp", "#pragma once\n#define INNER 35\n",
          "vector", "#include_next <vector>\n",
          "unrelated.hpp", "#pragma once\n#define UNRELATED 36\n");

  private final Random random;
  private final List<Project> projects;
  private final Path objects;
  private final Map<Project, List<Project>> earlier = new HashMap<>();

  Edits(Random random, List<Project> projects, Path objects) {
    this.random = random;
    this.projects = projects;
    this.objects = objects;
  }

  /** Edits a project; returns a short description. */
  String edit(Project project) throws Exception {
    earlier.computeIfAbsent(project, p -> new ArrayList<>()).add(project.copy());
    int percent = random.nextInt(100);
    if (percent < 40) {
      return changeNumber(project, project.java ? "(.*\\.java)" : "(.*\\.(hpp|cpp|cc|txt))");
    } else if (percent < 50) {
      return changeNumber(project, "(.*\\.(txt|csv|properties|yaml))");
    } else if (percent < 68) {
      return project.java ? addOrRemoveClass(project) : addOrRemoveHeader(project);
    } else if (percent < 78) {
      return changeFlags(project);
    } else if (percent < 84) {
      return addOrRemoveUnit(project);
    } else if (percent < 92) {
      List<Project> states = earlier.get(project);
      project.becomeLike(states.get(random.nextInt(states.size())));
      return "reverted to an earlier state";
    }
    int at = projects.indexOf(project);
    Project other = projects.get((at + projects.size() / 2) % projects.size());
    project.becomeLike(other);
    return "replaced by " + other.name;
  }

  private <T> T one(List<T> of) {
    return of.get(random.nextInt(of.size()));
  }

  private String changeNumber(Project project, String which) {
    List<String> paths = project.files.keySet().stream().filter(p -> p.matches(which)).toList();
    String path = one(paths);
    String text = project.text(path);
    List<int[]> places = new ArrayList<>();
    for (Matcher number = NUMBER.matcher(text); number.find(); ) {
      String line = text.substring(text.lastIndexOf('\n', number.start()) + 1, number.start());
      if (!line.contains("include") && !line.contains("asm") && !path.endsWith(".yaml") && !line.contains("blob")) {
        places.add(new int[] {number.start(), number.end()});
      }
    }
    if (places.isEmpty()) {
      project.put(path, text + (path.matches(".*\\.(yaml|properties|txt|csv)") ? "# " : "// ") + random.nextInt(100) + "\n");
      return "added a comment to " + path;
    }
    int[] place = one(places);
    project.put(path, text.substring(0, place[0]) + (1 + random.nextInt(9)) + text.substring(place[1]));
    return "changed a number in " + path;
  }

  /** Before or after the existing file in the search path, or outside of it. */
  private String addOrRemoveHeader(Project project) {
    List<String> folders = new ArrayList<>(List.of("shared/", "shared/more/", "docs/", "world/", "include/"));
    folders.add(project.sources());
    folders.add(project.sources() + "values/");
    if (project.component.containsKey("adapter")) {
      folders.add("adapter/");
    }
    String name = one(ASKED.keySet().stream().sorted().toList());
    String path = one(folders) + name;
    if (project.files.containsKey(path) && !path.startsWith("include/") && !path.equals("shared/more/inner.hpp") && !path.endsWith("values/deep.hpp")) {
      project.files.remove(path);
      return "removed " + path;
    }
    if (path.endsWith("vector") && random.nextBoolean()) {
      return changeNumber(project, ".*\\.hpp");
    }
    project.put(path, ASKED.get(name));
    return "added " + path;
  }

  private String addOrRemoveClass(Project project) {
    String path = one(List.of("docs/demo/More.java", project.sources() + "demo/More.java", project.sources() + "demo/more.txt", "world/More.java"));
    if (project.files.remove(path) != null) {
      return "removed " + path;
    }
    project.put(path, "package demo;\nclass More { static final int VALUE = " + random.nextInt(9) + "; }\n");
    return "added " + path;
  }

  private String changeFlags(Project project) throws Exception {
    if (!project.libraries.isEmpty()) {
      String library = project.libraries.get(0);
      String kind = library.substring(library.lastIndexOf('.'));
      int version = random.nextInt(2);
      project.files.put(library, Files.readAllBytes(objects.resolve("extra" + version + kind)));
      return library + " of version " + version;
    }
    if (!project.java && random.nextBoolean()) {
      boolean second = project.component.get("headers").equals("include2/");
      project.component.put("headers", second ? "include/" : "include2/");
      return "headers: " + project.component.get("headers");
    }
    if (project.component.containsKey("adapter")) {
      boolean second = project.component.get("adapter").equals("adapter2/");
      project.files.keySet().stream().filter(p -> p.startsWith("adapter/")).toList()
          .forEach(p -> project.files.put("adapter2/" + p.substring(8), project.files.get(p)));
      project.component.put("adapter", second ? "adapter/" : "adapter2/");
    } else {
      project.component.put("adapter", "adapter/");
      project.put(
          project.java ? "adapter/demo/Added.java" : "adapter/added.cpp",
          project.java ? "package demo;\nclass Added {}\n" : "int added() { return 1; }\n");
    }
    return "adapter: " + project.component.get("adapter");
  }

  private String addOrRemoveUnit(Project project) {
    if (project.java) {
      return addOrRemoveClass(project);
    }
    String path = project.sources() + "more.cpp";
    if (project.files.remove(path) != null) {
      return "removed " + path;
    }
    project.put(path, "#include \"right.hpp\"\nint more() { return RIGHT + " + random.nextInt(9) + "; }\n");
    return "added " + path;
  }
}
