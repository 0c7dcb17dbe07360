package org.sitaf.core.harness;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.CaseParameter;

/**
 * Names of interfaces, methods, parameters, structs, members, enumerations and exceptions with a
 * meaning in a language or in generated code. Each is rejected, or the generated sources compile.
 */
@Tag("slow")
class HostileNamesTest {

  /** Invalid names in all languages: each must be rejected in every position. */
  private static final List<String> NO_NAMES =
      List.of(
          "",
          " ",
          "a b",
          "1a",
          "a;b",
          "a\"b",
          "a'b",
          "a(b",
          "a//",
          "a/*",
          "a\\u0022",
          "a\nb",
          "a\u2028b",
          "{{x}}",
          "a#b",
          "x = 1; System.exit(9); int y",
          "x\nimport os; os._exit(9)\ny",
          "x; std::abort(); int y",
          "\u202ea");

  /** Words of languages, their libraries, the runtimes and the templates. */
  private static final List<String> WORDS =
      Arrays.stream(
              """
              and as assert async await break class continue def del elif else except finally for from global if import
              in is lambda nonlocal not or pass raise return try while with yield None True False match case type self
              abstract boolean byte catch char const default do double enum extends final float goto implements
              instanceof int interface long native new package private protected public short static strictfp super
              switch synchronized this throw throws transient void volatile null true false record sealed permits var
              auto bool delete explicit export extern friend inline mutable namespace noexcept nullptr operator register
              signed sizeof struct template typedef typename union unsigned using virtual co_await concept requires
              errno NULL NAN EOF INT_MAX stdin linux unix assert main std sitaf std_ string vector array
              String Object List Map Double Integer Exception Error RuntimeException Override Math System Record Enum
              str list dict tuple object Any Exception_ ABC abstractmethod dataclass field print id len super_ property
              Hardware Out InOut Stopwatch TestRun TestCase CaseResult SuiteDriver TestDriver TestStub SimulationControl
              ConcreteTestDriver Component ComponentUnderTest Answer Answers Stubbing StubbedMethod Stub Kind Tolerance
              Neighbour NeighbourStub EchoService Echo LifeCycle Duration Nothing
              call calls caller result results returned testCase test_case component run runtime stopwatch
              NonblockingCall callNonblocking call_nonblocking
              pending outcome save prepare settle observe begin end execute start stop close answer reset value values
              beforeCase afterCase before_case after_case runCase run_case createComponent create_component newComponent
              new_component simulation simulationControl simulation_control testStub test_stub stubbing args argc argv
              suite harness interfaces literals ERRORS raise name wait notify notifyAll hashCode toString getClass
              equals clone finalize init __init__ __class__ _private __double a__b _A mro ordinal valueOf
              method_of call_with_outs port_of part_of set_property sitaf_runtime sitaf_interfaces sitaf_harness
              toggle lowerCamel UpperCamel snake_case SHOUTED x X1
              """
                  .strip()
                  .split("\\s+"))
          .distinct()
          .toList();

  /** Names that are accepted in every position. */
  private static final List<String> ORDINARY_NAMES =
      List.of("lowerCamel", "UpperCamel", "snake_case", "x", "X1");

  /**
   * One of so many words is compiled in each position unless long tests run. The first words of
   * nine positions in three languages have eleven different numbers.
   */
  private static final int SAMPLED = 11;

  @TempDir Path folder;

  static Stream<Arguments> everywhere() {
    return Arrays.stream(Language.values())
        .flatMap(l -> Arrays.stream(NamePosition.values()).map(p -> Arguments.of(l, p)));
  }

  /** Each position gets other names, so that together they cover all names. */
  @ParameterizedTest
  @MethodSource("everywhere")
  void rejectsOrCompilesSampledNames(Language language, NamePosition position)
      throws IOException, InterruptedException {
    List<String> names = new ArrayList<>(ORDINARY_NAMES);
    int first = (position.ordinal() + language.ordinal()) % SAMPLED;
    for (int i = first; i < WORDS.size(); i += SAMPLED) {
      names.add(WORDS.get(i));
    }
    assertRejectedOrCompiled(language, position, names.stream().distinct().toList());
  }

  @ParameterizedTest
  @MethodSource("everywhere")
  @Tag("long")
  void rejectsOrCompilesEveryName(Language language, NamePosition position)
      throws IOException, InterruptedException {
    assertRejectedOrCompiled(language, position, WORDS);
  }

  private void assertRejectedOrCompiled(
      Language language, NamePosition position, List<String> words)
      throws IOException, InterruptedException {
    LanguageCompiler compiler = new LanguageCompiler(language, folder);
    Assumptions.assumeTrue(compiler.isInstalled(), language + ": no compiler is installed");
    List<String> accepted = new ArrayList<>();
    for (String name : Stream.concat(NO_NAMES.stream(), words.stream()).toList()) {
      Throwable rejection = catchThrowable(() -> generate(language, position, List.of(name)));
      if (rejection == null) {
        assertThat(NO_NAMES).doesNotContain(name);
        accepted.add(name);
      } else {
        assertThat(rejection).as(name).isInstanceOf(InvalidInputException.class);
      }
    }
    assertThat(accepted).containsAll(ORDINARY_NAMES);
    TestApplication application = generate(language, position, compatible(language, accepted));
    assertThat(compiler.compile(application)).isEmpty();
  }

  /**
   * Selects names that one application may contain together. In Python and Java, names that differ
   * only in case and underscores would give the same module, alias, or file on a case-insensitive
   * file system. In C++, a word that is no name gets an underscore. In Python, a name that ends
   * with Stub may be that of another interface's stub, so it is only tested alone.
   */
  private static List<String> compatible(Language language, List<String> accepted) {
    Map<String, String> first = new HashMap<>();
    List<String> kept = new ArrayList<>();
    for (String name : accepted) {
      String folded =
          language == Language.CPP
              ? name.replaceFirst("_$", "")
              : name.toLowerCase(java.util.Locale.ROOT).replace("_", "");
      boolean stub = language == Language.PYTHON && name.endsWith("Stub");
      if (!stub && first.putIfAbsent(folded, name) == null) {
        kept.add(name);
      }
    }
    return kept;
  }

  private static TestApplication generate(
      Language language, NamePosition position, List<String> names) {
    List<InterfaceDescription> provided = position.provided(names);
    List<InterfaceDescription> required = position.required(names);
    Method say = provided.get(0).methods().get(0);
    List<CaseParameter> columns = new ArrayList<>();
    List<String> values = new ArrayList<>();
    for (Parameter parameter : say.parameters()) {
      columns.add(new CaseParameter(parameter.name(), InputKind.TDI, "string"));
      values.add("hello");
    }
    for (InterfaceDescription stub : required) {
      for (Method method : stub.methods()) {
        columns.add(new CaseParameter(stub.name() + "." + method.name(), InputKind.TDTS, "string"));
        values.add("!delay:0.001");
      }
    }
    return new OneCase(
            language,
            language == Language.CPP ? "robot::Echo" : "robot.Echo",
            "Say",
            "",
            Map.of(),
            List.of(),
            component(language, say.parameters().size()),
            provided,
            required,
            columns,
            values)
        .application();
  }

  /** A component whose method has the given number of string parameters. */
  private static FileTree component(Language language, int texts) {
    String sources =
        switch (language) {
          case JAVA ->
              "package robot;\npublic final class Echo {\n  public String Say("
                  + numbered(texts, "String text%d")
                  + ") { return \"\"; }\n}\n";
          case CPP ->
              "#pragma once\n#include <string>\nnamespace robot {\nclass Echo {\n public:\n"
                  + "  std::string Say("
                  + numbered(texts, "const std::string& text%d")
                  + ") { return {}; }\n};\n}\n";
          case PYTHON -> "class Echo:\n    def say(self, *texts):\n        return ''\n";
        };
    String path =
        switch (language) {
          case JAVA -> "component/robot/Echo.java";
          case CPP -> "component/echo.hpp";
          case PYTHON -> "component/robot.py";
        };
    return FileTree.of(Map.of(path, sources.getBytes(StandardCharsets.UTF_8)));
  }

  private static String numbered(int count, String format) {
    List<String> parts = new ArrayList<>();
    for (int i = 0; i < count; i++) {
      parts.add(format.formatted(i));
    }
    return String.join(", ", parts);
  }
}
