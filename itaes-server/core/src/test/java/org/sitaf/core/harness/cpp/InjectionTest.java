package org.sitaf.core.harness.cpp;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.LanguageCompiler;
import org.sitaf.core.harness.TestApplication;

/** Hostile names and values in strings, comments, identifiers and templates do not become code. */
class InjectionTest {
  /** Without escaping, each of these texts would run code or make the source invalid. */
  private static final List<String> HOSTILE =
      List.of(
          "\"); std::abort(); //",
          "\\\"); std::abort(); //",
          "??/\"); std::abort(); //",
          "*/ static int x = (std::abort(), 0); /*",
          "ends with a backslash \\",
          "ends with a trigraph ??/",
          "u0022 \\u0022); std::abort(); //",
          ")\" R\"(x)\"",
          "#include </etc/passwd>",
          "{{namespace}} {{{component}}} {{#includes}}",
          "%s %n %d",
          "tab\tbell\u0007escape\u001b",
          "line\nbreak",
          "\u2028 std::abort(); //",
          "\u202e right to left",
          "\uD83E\uDD16 ü 한국어 0123",
          "a".repeat(3000));

  @TempDir Path folder;

  private static String yaml(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    text.codePoints()
        .forEach(
            c -> {
              if (c < 0x20 || c > 0x7e || c == '"' || c == '\\') {
                quoted.append("\\U%08x".formatted(c));
              } else {
                quoted.append((char) c);
              }
            });
    return quoted.append('"').toString();
  }

  private static byte[] bytes(String text) {
    return text.getBytes(StandardCharsets.UTF_8);
  }

  /** The example with these texts in all places of users' texts. */
  private static TestApplication generate(String property, String value, String description)
      throws IOException {
    FileTree files = GoldenHarnessTest.tree(Path.of("../../examples/ir-sensor-cpp"));
    String profile = files.text("activity.yaml").orElseThrow();
    String model = files.text("GetInfraredData.xml").orElseThrow();
    String header = files.text("component/infrared_sensor.hpp").orElseThrow();
    return GoldenHarnessTest.generate(
        files
            .with(
                "component/infrared_sensor.hpp",
                bytes(
                    header.replace(
                        "void setSize(int size);",
                        "void setProperty(const std::string& name, const std::string& value);")))
            .with(
                "activity.yaml",
                bytes(
                    profile.replace("{Size: 7}", "{" + yaml(property) + ": " + yaml(value) + "}")))
            .with(
                "GetInfraredData.xml",
                bytes(
                    model.replaceFirst(
                        "(?s)<description>.*?</description>",
                        java.util.regex.Matcher.quoteReplacement(
                            "<description>" + xml(description) + "</description>")))));
  }

  /** Without characters that XML does not allow. */
  private static String xml(String text) {
    return text.replaceAll("[\\x00-\\x08\\x0b-\\x1f]", "")
        .replace("&", "&amp;")
        .replace("<", "&lt;");
  }

  @Test
  void noTextLeavesItsStringOrComment() throws IOException {
    for (String text : HOSTILE) {
      // The length of a YAML key is limited.
      String name = "x" + text.substring(0, Math.min(text.length(), 200));
      TestApplication application = generate(name, text, text);
      for (String path : application.harness().paths()) {
        String source = application.harness().text(path).orElseThrow();
        String code =
            source
                .lines()
                .filter(line -> !line.strip().startsWith("//"))
                .map(line -> line.replaceAll("\"(?:[^\"\\\\]++|\\\\.)*+\"", "\"\""))
                .collect(Collectors.joining("\n"));
        assertThat(code).as("%s: %s", path, text).doesNotContain("abort", "passwd", "한국어");
        assertThat(source.lines().filter(line -> line.strip().startsWith("//")))
            .as("%s: %s", path, text)
            .noneMatch(line -> line.endsWith("\\") || line.endsWith("??/"));
      }
    }
  }

  @Test
  @Tag("slow")
  void hostileTextsCompile() throws IOException, InterruptedException {
    Assumptions.assumeTrue(
        new LanguageCompiler(Language.CPP, folder).isInstalled(), "g++ is not installed");
    TestApplication application =
        generate(
            "x" + String.join(" ", HOSTILE).substring(0, 300),
            String.join(" ", HOSTILE),
            String.join(" ", HOSTILE));
    assertThat(compile(application)).isEmpty();
  }

  @Test
  @Tag("slow")
  void everyKindOfTypeAndStubCompiles() throws IOException, InterruptedException {
    Assumptions.assumeTrue(
        new LanguageCompiler(Language.CPP, folder).isInstalled(), "g++ is not installed");
    Path wide = Path.of("src/test/resources/org/sitaf/core/harness/cpp/wide-activity");
    assertThat(compile(GoldenHarnessTest.generate(GoldenHarnessTest.tree(wide)))).isEmpty();
  }

  /** The output of the compiler; empty if the sources compile. */
  private String compile(TestApplication application) throws IOException, InterruptedException {
    FileTree files = application.files();
    for (String path : files.paths()) {
      Path file = folder.resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, files.content(path).orElseThrow());
    }
    String runtime = Path.of("../../tba-agent/runtime-cpp/include").toAbsolutePath().toString();
    List<String> command = new ArrayList<>(List.of("g++", "-std=c++17", "-fsyntax-only", "-Wall"));
    command.addAll(List.of("-I", folder.resolve("harness").toString(), "-I", runtime));
    command.addAll(
        List.of("-I", folder.resolve("harness").resolve(application.entryPoint()).toString()));
    command.addAll(List.of("-I", folder.resolve("activity/component").toString()));
    application.harness().paths().stream()
        .filter(path -> path.endsWith(".cpp"))
        .forEach(path -> command.add(folder.resolve("harness").resolve(path).toString()));
    Process compiler = new ProcessBuilder(command).redirectErrorStream(true).start();
    String output = new String(compiler.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return compiler.waitFor() == 0 ? output : "failed: " + output;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "a b",
        "a-b",
        "1a",
        "a;b",
        "a(",
        "a\\u0022",
        "a//b",
        "a/*",
        "{{x}}",
        "class",
        "int",
        "template",
        "co_await",
        "a__b",
        "_A",
        "errno",
        "robot::",
        "robot::class",
        "robot.Infra"
      })
  void rejectsClassNamesThatAreNotCppNames(String name) throws IOException {
    FileTree files = GoldenHarnessTest.tree(Path.of("../../examples/ir-sensor-cpp"));
    String profile = files.text("activity.yaml").orElseThrow();
    FileTree changed =
        files.with("activity.yaml", bytes(profile.replace("robot::InfraredSensor", yaml(name))));
    assertThatThrownBy(() -> GoldenHarnessTest.generate(changed))
        .isInstanceOf(InvalidInputException.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"class", "template", "a__b", "_Get", "errno", "assert", "operator"})
  void rejectsMethodNamesThatAreNotCppIdentifiers(String name) throws IOException {
    FileTree files = GoldenHarnessTest.tree(Path.of("../../examples/ir-sensor-cpp"));
    FileTree changed = files;
    for (String path : List.of("InfraredSensorService.xml", "GetInfraredData.xml")) {
      String text = files.text(path).orElseThrow();
      changed = changed.with(path, bytes(text.replace("\"GetInfraredData\"", "\"" + name + "\"")));
    }
    FileTree renamed = changed;
    assertThatThrownBy(() -> GoldenHarnessTest.generate(renamed))
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining(name);
  }
}
