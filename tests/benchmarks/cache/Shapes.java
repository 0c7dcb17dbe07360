import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The activities to edit: each kind exists twice, as if two users had started with the same one. */
final class Shapes {
  private static final int USERS = 2;

  private Shapes() {}

  /** Eighteen activities in C++ and twelve in Java. */
  static List<Project> all(Path objects, Path home) throws Exception {
    List<Project> all = new ArrayList<>();
    for (int user = 0; user < USERS; user++) {
      for (int kind = 0; kind < 9; kind++) {
        all.add(cpp("cpp-" + kind + "-" + user, kind, objects, home));
      }
      for (int kind = 0; kind < 6; kind++) {
        all.add(java("java-" + kind + "-" + user, kind, objects, home));
      }
    }
    return all;
  }

  private static Project cpp(String name, int kind, Path objects, Path home) throws Exception {
    Project project = new Project(name, false);
    String sources = kind == 5 ? "world/component/" : "component/";
    project.component.put("sources", sources);
    project.put(sources + "component.hpp", "#pragma once\nstruct Component { int total(); };\n");
    StringBuilder component = new StringBuilder("#include \"component.hpp\"\n");
    component.append("#include \"config.hpp\"\nint left();\nint right();\n");
    String sum = "CONFIG + left() + right()";
    project.put(sources + "left.cpp", "#include \"values/left.hpp\"\nint left() { return LEFT; }\n");
    project.put(sources + "right.cc", "#include \"right.hpp\"\nint right() { return RIGHT; }\n");
    project.put(sources + "values/left.hpp", "#pragma once\n#include \"deep.hpp\"\n#define LEFT (1 + DEEP)\n");
    project.put(sources + "values/deep.hpp", "#pragma once\n#define DEEP 2\n");
    project.put("notes.txt", "nothing that a compiler reads 0\n");
    project.put("data/table.csv", "1\n");
    // A header in the last folder of the include path, so that other headers can hide it.
    project.component.put("headers", "include/");
    project.put("include/config.hpp", "#pragma once\nenum { CONFIG = 3 };\n");
    project.put("include/right.hpp", "#pragma once\n#define RIGHT 4\n");
    project.put("include2/config.hpp", "#pragma once\nenum { CONFIG = 20 };\n");
    project.put("include2/right.hpp", "#pragma once\n#define RIGHT 21\n");
    project.put("include2/chosen.hpp", "#pragma once\n#define CHOSEN 22\n");
    switch (kind) {
      case 0 -> {
        // Nothing more.
      }
      case 1 -> {
        // Included sources, of the component and from another folder.
        project.put(sources + "part.cc", "static int part() { return 5; }\nint use_part() { return part(); }\n");
        project.put("shared/other.cc", "static int other() { return 6; }\n");
        component.append("namespace again {\n#include \"part.cc\"\n}\n#include \"../shared/other.cc\"\n");
        sum += " + again::part() + other()";
      }
      case 2 -> {
        // Headers outside of sources and headers.
        project.put("shared/common.hpp", "#pragma once\n#include \"more/inner.hpp\"\n#define COMMON (7 + INNER)\n");
        project.put("shared/more/inner.hpp", "#pragma once\n#define INNER 8\n");
        component.append("#include \"../shared/common.hpp\"\n");
        sum += " + COMMON";
      }
      case 3 -> {
        component.append("#if __has_include(\"option.hpp\")\n#include \"option.hpp\"\n#else\n#define OPTION 9\n#endif\n");
        component.append("#if __has_include(\"only-asked.hpp\")\n#define ASKED 1\n#else\n#define ASKED 0\n#endif\n");
        sum += " + OPTION + ASKED";
      }
      case 4 -> {
        project.put("include/chosen.hpp", "#pragma once\n#define CHOSEN 10\n");
        component.append("#define NAME \"chosen.hpp\"\n#include NAME\n");
        sum += " + CHOSEN";
      }
      case 5 -> {
        // Sources and headers within the folder of the world.
        project.world("world/", home);
        project.put("world/scale.hpp", "#pragma once\n#define SCALE 11\n");
        component.append("#include \"../scale.hpp\"\n");
        sum += " + SCALE";
      }
      case 6 -> {
        project.put(sources + "table.txt", "table 0\n");
        component.append("asm(\".section .rodata\\n.global blob\\nblob: .incbin \\\"table.txt\\\"\\n.byte 0\\n.text\");\n");
        component.append("extern \"C\" const unsigned char blob[];\n");
        sum += " + blob[6]";
      }
      case 7 -> {
        // The world is at the top level, next to unrelated files.
        project.world("", home);
        project.files.put("lib/libextra.a", Files.readAllBytes(objects.resolve("extra0.a")));
        project.libraries.add("lib/libextra.a");
        component.append("int extra();\n");
        sum += " + extra()";
      }
      default -> {
        project.component.put("adapter", "adapter/");
        project.put("adapter/adapter.cpp", "#include <vector>\n#include \"config.hpp\"\nint adapted() { return CONFIG + (int) std::vector<int>(2).size(); }\n");
        component.append("#include <string>\nint adapted();\n");
        sum += " + adapted() + (int) std::string(\"ab\").size()";
      }
    }
    component.append("int Component::total() { return " + sum + "; }\n");
    project.put(sources + "component.cpp", component.toString());
    return project;
  }

  private static Project java(String name, int kind, Path objects, Path home) throws Exception {
    Project project = new Project(name, true);
    String sources = kind == 3 ? "world/component/" : "component/";
    project.component.put("sources", sources);
    // The compiler copies constants into the classes that use them.
    project.put(sources + "demo/Constants.java", "package demo;\nclass Constants { static final int VALUE = 1; }\n");
    project.put(sources + "demo/Deep.java", "package demo;\nclass Deep { static final int VALUE = Constants.VALUE + 2; }\n");
    project.put("notes.txt", "nothing that a compiler reads 0\n");
    String sum = "Constants.VALUE + Deep.VALUE";
    switch (kind) {
      case 0 -> {
        // Nothing more.
      }
      case 1 -> project.put(sources + "demo/table.properties", "value=3\n");
      case 2 -> {
        project.component.put("adapter", "adapter/");
        project.put("adapter/demo/Adapter.java", "package demo;\nclass Adapter { static final int VALUE = 4; }\n");
        sum += " + Adapter.VALUE";
      }
      case 3 -> {
        project.world("world/", home);
      }
      case 4 -> {
        project.files.put("lib/extra.jar", Files.readAllBytes(objects.resolve("extra0.jar")));
        project.libraries.add("lib/extra.jar");
        sum += " + extra.Extra.VALUE";
      }
      default -> {
        // The folder of the world is the whole activity.
        project.world("", home);
        project.put(sources + "demo/Nested.java", "package demo;\ninterface Nested { interface Inner { int VALUE = 6; } }\n");
        sum += " + Nested.Inner.VALUE";
      }
    }
    project.put(sources + "demo/Component.java", "package demo;\npublic class Component { public int total() { return " + sum + "; } }\n");
    return project;
  }
}
