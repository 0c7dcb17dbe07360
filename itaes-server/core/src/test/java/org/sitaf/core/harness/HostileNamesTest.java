package org.sitaf.core.harness;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowable;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Stream;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.ActivityProfile.LifeCycle;
import org.sitaf.core.activity.ActivityProfile.Limits;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.model.InvalidValues;
import org.sitaf.core.model.Strength;
import org.sitaf.core.model.Target;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.suite.CaseParameter;
import org.sitaf.core.suite.Generation;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestSuite;

/**
 * Names of interfaces, methods, parameters, structs, members, enumerations and exceptions that mean
 * something to a language or to generated code: each is refused, or what comes out of all that are
 * not refused compiles.
 */
@Tag("slow")
class HostileNamesTest {
  private static final DataType STRING = new DataType.Scalar(ScalarType.STRING);
  private static final DataType DOUBLE = new DataType.Scalar(ScalarType.DOUBLE);
  private static final DataType INT = new DataType.Scalar(ScalarType.INT32);
  private static final DataType VOID = new DataType.Scalar(ScalarType.VOID);

  /** No name in any language: each must be refused wherever it would be one. */
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

  /** Words that languages, their libraries, the runtimes and the templates use. */
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
              call calls caller result results returned testCase test_case component run runtime stopwatch beside
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

  /** Where a name stands, and the interfaces that hold some names there. */
  private enum Position {
    PARAMETER,
    STUB,
    STUB_METHOD,
    STUB_PARAMETER,
    STRUCT,
    MEMBER,
    ENUMERATION,
    LITERAL,
    EXCEPTION;

    List<InterfaceDescription> provided(List<String> names) {
      List<Parameter> parameters =
          this == PARAMETER
              ? names.stream().map(n -> new Parameter(n, STRING, Direction.IN)).toList()
              : List.of(new Parameter("text", STRING, Direction.IN));
      Method say = new Method("Say", STRING, parameters, CallType.BLOCKING, 1);
      return List.of(new InterfaceDescription("EchoService", List.of(say), "provided.xml"));
    }

    List<InterfaceDescription> required(List<String> names) {
      return switch (this) {
        case PARAMETER -> List.of();
        case STUB -> names.stream().map(n -> required(n, List.of(method("Ask", INT)))).toList();
        case STUB_METHOD -> List.of(neighbour(names, n -> method(n, INT)));
        case STUB_PARAMETER ->
            List.of(
                required(
                    "Neighbour",
                    chunks(names).entrySet().stream()
                        .flatMap(
                            c ->
                                Stream.of(
                                    method("In" + c.getKey(), INT, c.getValue(), Direction.IN),
                                    method("Out" + c.getKey(), VOID, c.getValue(), Direction.OUT),
                                    method(
                                        "Both" + c.getKey(),
                                        DOUBLE,
                                        c.getValue(),
                                        Direction.INOUT)))
                        .toList()));
        case STRUCT ->
            List.of(
                numbered(
                    names, n -> new DataType.Struct(n, List.of(new DataType.Member("x", DOUBLE)))));
        case ENUMERATION ->
            List.of(numbered(names, n -> new DataType.Enumeration(n, List.of("ONE", "TWO"))));
        case MEMBER ->
            List.of(
                numbered(
                    chunks(names).keySet().stream().map(i -> "Shape" + i).toList(),
                    shape ->
                        new DataType.Struct(
                            shape,
                            chunks(names).get(Integer.parseInt(shape.substring(5))).stream()
                                .map(n -> new DataType.Member(n, DOUBLE))
                                .toList())));
        case LITERAL -> List.of(numbered(List.of("Mode"), m -> new DataType.Enumeration(m, names)));
        case EXCEPTION ->
            List.of(
                required(
                    "Neighbour",
                    List.of(new Method("Ask", INT, List.of(), CallType.BLOCKING, names, 1))));
      };
    }

    private static InterfaceDescription required(String name, List<Method> methods) {
      return new InterfaceDescription(name, methods, "required.xml");
    }

    private static InterfaceDescription neighbour(
        List<String> names, Function<String, Method> method) {
      return required("Neighbour", names.stream().map(method).toList());
    }

    /** Java takes no more than 255 parameters, and two of these for each double. */
    private static Map<Integer, List<String>> chunks(List<String> names) {
      Map<Integer, List<String>> chunks = new TreeMap<>();
      for (int i = 0; i < names.size(); i++) {
        chunks.computeIfAbsent(i / 100, n -> new ArrayList<>()).add(names.get(i));
      }
      return chunks;
    }

    /** A method for each type that gives and takes it. */
    private static InterfaceDescription numbered(
        List<String> names, Function<String, DataType> type) {
      List<Method> methods = new ArrayList<>();
      for (int i = 0; i < names.size(); i++) {
        DataType made = type.apply(names.get(i));
        methods.add(
            new Method(
                "Ask" + i,
                made,
                List.of(
                    new Parameter("given", made, Direction.IN),
                    new Parameter("taken", made, Direction.OUT)),
                CallType.BLOCKING,
                1));
      }
      return required("Neighbour", methods);
    }

    private static Method method(String name, DataType returns) {
      return new Method(name, returns, List.of(), CallType.BLOCKING, 1);
    }

    private static Method method(
        String name, DataType returns, List<String> parameters, Direction direction) {
      return new Method(
          name,
          returns,
          parameters.stream().map(p -> new Parameter(p, DOUBLE, direction)).toList(),
          CallType.BLOCKING,
          1);
    }
  }

  @TempDir Path folder;

  static Stream<Arguments> everywhere() {
    return Arrays.stream(Language.values())
        .flatMap(l -> Arrays.stream(Position.values()).map(p -> Arguments.of(l, p)));
  }

  @ParameterizedTest
  @MethodSource("everywhere")
  void aNameIsRefusedOrCompiles(Language language, Position position)
      throws IOException, InterruptedException {
    Assumptions.assumeTrue(has(language), language + ": no compiler is installed");
    List<String> accepted = new ArrayList<>();
    for (String name : Stream.concat(NO_NAMES.stream(), WORDS.stream()).toList()) {
      Throwable refused = catchThrowable(() -> generate(language, position, List.of(name)));
      if (refused == null) {
        assertThat(NO_NAMES).doesNotContain(name);
        accepted.add(name);
      } else {
        assertThat(refused).as(name).isInstanceOf(InvalidInputException.class);
      }
    }
    assertThat(accepted).contains("lowerCamel", "UpperCamel", "snake_case", "x", "X1");
    TestApplication application = generate(language, position, together(language, accepted));
    for (String path : application.harness().paths()) {
      write(path, application.harness().content(path).orElseThrow());
    }
    assertThat(compile(language, application)).isEmpty();
  }

  /**
   * Of names that differ in case and underscores only, Python and Java get one: the modules and
   * aliases of the others would be the same, and so would files where the system tells no cases
   * apart. What Python calls the stub of another interface stands for itself alone.
   */
  private static List<String> together(Language language, List<String> accepted) {
    Map<String, String> first = new HashMap<>();
    List<String> kept = new ArrayList<>();
    for (String name : accepted) {
      String folded = name.toLowerCase(java.util.Locale.ROOT).replace("_", "");
      boolean stub = language == Language.PYTHON && name.endsWith("Stub");
      if (!stub && (first.putIfAbsent(folded, name) == null || language == Language.CPP)) {
        kept.add(name);
      }
    }
    return kept;
  }

  private static TestApplication generate(
      Language language, Position position, List<String> names) {
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
    TestModel model =
        new TestModel(
            "Say",
            "",
            new Target("EchoService", "Say", null, Duration.ZERO, Duration.ZERO),
            List.of(),
            List.of(),
            List.of(),
            List.of(),
            InvalidValues.ISOLATE,
            new Strength(1),
            List.of(),
            List.of(),
            "model.xml");
    TestSuite suite =
        new TestSuite(
            "s",
            "",
            "Say",
            new Generation(new Strength(1), InvalidValues.ISOLATE, 1, "default", "test"),
            columns,
            List.of(new TestCase(1, true, values, List.of())));
    Activity activity =
        new Activity(
            profile(language),
            component(language, say.parameters().size()),
            provided,
            required,
            List.of(),
            null,
            List.of(model),
            List.of());
    return InterfaceTestApplicationGenerator.generate(activity, model, suite);
  }

  private static ActivityProfile profile(Language language) {
    String className =
        switch (language) {
          case JAVA -> "robot.Echo";
          case CPP -> "robot::Echo";
          case PYTHON -> "robot.Echo";
        };
    Component component =
        new Component(
            language,
            "component/",
            null,
            null,
            null,
            null,
            className,
            null,
            null,
            Map.of(),
            LifeCycle.CASE,
            null,
            List.of());
    return new ActivityProfile(
        "echo",
        "",
        component,
        List.of("provided.xml"),
        List.of("required.xml"),
        List.of(),
        language,
        null,
        List.of("model.xml"),
        false,
        Limits.DEFAULT);
  }

  /** A component whose method takes so many texts, whatever they are called. */
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

  private static boolean has(Language language) {
    String program =
        switch (language) {
          case JAVA -> "java";
          case CPP -> "g++";
          case PYTHON -> "python3";
        };
    return Arrays.stream(System.getenv("PATH").split(File.pathSeparator))
        .anyMatch(bin -> Files.isExecutable(Path.of(bin, program)));
  }

  private void write(String path, byte[] content) throws IOException {
    Path file = folder.resolve(path);
    Files.createDirectories(file.getParent());
    Files.write(file, content);
  }

  /** What the compiler says of all that was generated; empty when it takes it. */
  private String compile(Language language, TestApplication application)
      throws IOException, InterruptedException {
    FileTree files = application.activity().files();
    for (String path : files.paths()) {
      write(path.substring("component/".length()), files.content(path).orElseThrow());
    }
    Path runtimes = Path.of("../../tba-agent").toAbsolutePath().normalize();
    List<String> command =
        switch (language) {
          case JAVA ->
              List.of(
                  Path.of(System.getProperty("java.home"), "bin", "javac").toString(),
                  "-proc:none",
                  "-Xmaxerrs",
                  "20",
                  "-encoding",
                  "UTF-8",
                  "-d",
                  folder.resolve("classes").toString(),
                  "-cp",
                  System.getProperty("java.class.path"));
          case CPP ->
              List.of(
                  "g++",
                  "-std=c++17",
                  "-fsyntax-only",
                  "-I",
                  folder.toString(),
                  "-I",
                  folder.resolve(application.entryPoint()).toString(),
                  "-I",
                  runtimes.resolve("runtime-cpp/include").toString());
          // Modules run when they are imported: all but the entry point, which is imported, too.
          case PYTHON ->
              List.of(
                  "python3",
                  "-W",
                  "error",
                  "-c",
                  "import sys; sys.path[:0] = sys.argv[1:3]; import " + application.entryPoint(),
                  folder.toString(),
                  runtimes.resolve("runtime-python/src").toString());
        };
    List<String> whole = new ArrayList<>(command);
    if (language == Language.JAVA) {
      try (Stream<Path> paths = Files.walk(folder)) {
        paths.map(Path::toString).filter(p -> p.endsWith(".java")).forEach(whole::add);
      }
    } else if (language == Language.CPP) {
      // In one unit, the headers are read once.
      StringBuilder all = new StringBuilder();
      application.harness().paths().stream()
          .filter(p -> p.endsWith(".cpp"))
          .forEach(p -> all.append("#include \"").append(p).append("\"\n"));
      Path unit = folder.resolve("all.cpp");
      Files.writeString(unit, all);
      whole.add(unit.toString());
    }
    Process compiler = new ProcessBuilder(whole).redirectErrorStream(true).start();
    String said = new String(compiler.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return compiler.waitFor() == 0 ? "" : "failed: " + said;
  }
}
