package org.sitaf.core.harness.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.description.CallType;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.Direction;
import org.sitaf.core.description.InterfaceDescription;
import org.sitaf.core.description.Method;
import org.sitaf.core.description.Parameter;
import org.sitaf.core.description.ScalarType;
import org.sitaf.core.diagnostic.InvalidInputException;
import org.sitaf.core.harness.OneCase;
import org.sitaf.core.harness.TestApplication;
import org.sitaf.core.model.InputKind;
import org.sitaf.core.suite.CaseParameter;

/** Hostile names and values in strings, comments, identifiers and templates do not become code. */
@Tag("slow")
class InjectionTest {
  private static final DataType STRING = new DataType.Scalar(ScalarType.STRING);

  /** Without escaping, each of these texts would run code or make the source invalid. */
  private static final List<String> HOSTILE =
      List.of(
          "\"; System.exit(9); //",
          "\\\"; System.exit(9); //",
          "\\u0022; System.exit(9); //",
          "\\\\u0022; System.exit(9); //",
          "*/ static { System.exit(9); } /*",
          "\\u002a\\u002f static { System.exit(9); } /*",
          "\\u000a static { System.exit(9); } //",
          "\\uuuu000a static { System.exit(9); } //",
          "\n static { System.exit(9); } //",
          "\r*/ static { System.exit(9); }",
          "\u2028 static { System.exit(9); } //",
          "{{packageName}} {{{component}}} {{#imports}}",
          "{@link System#exit} @param <b> & &lt; {@code",
          "\\",
          "\\u",
          "\u0000\u0007\u001b\u007f\u0085\u202e",
          "${jndi:ldap://127.0.0.1/x} #{1+1} %s %n",
          "'); DROP TABLE cases; --",
          "\uD83E\uDD16 ü 한국어",
          "*\\/ /** // /*",
          "a".repeat(5000));

  @TempDir Path folder;

  private String className = "robot.Echo";
  private String interfaceName = "EchoService";
  private String method = "Say";
  private String parameter = "text";
  private String modelName = "Say";
  private String description = "";
  private String source = "provided.xml";
  private final Map<String, String> properties = new TreeMap<>();
  private final List<String> before = new ArrayList<>();
  private List<InterfaceDescription> required = List.of();

  private TestApplication generate() {
    Method say =
        new Method(
            method,
            STRING,
            List.of(new Parameter(parameter, STRING, Direction.IN)),
            CallType.BLOCKING,
            1);
    return new OneCase(
            Language.JAVA,
            className,
            modelName,
            description,
            properties,
            before,
            HarnessBuild.tree(Map.of("model.xml", "", "component/robot/Echo.java", ECHO)),
            List.of(new InterfaceDescription(interfaceName, List.of(say), source)),
            required,
            List.of(new CaseParameter(parameter, InputKind.TDI, "string")),
            List.of("hello"))
        .application();
  }

  /** Returns all received texts as the codes of their characters. */
  private static final String ECHO =
      """
      package robot;

      public final class Echo {
        private final StringBuilder received = new StringBuilder();

        public void setProperty(String name, String value) {
          Say(name);
          Say(value);
        }

        public String Say(String text) {
          text.chars().forEach(c -> received.append(c).append(' '));
          received.append(';');
          return received.toString();
        }
      }
      """;

  private static String numbers(String text) {
    StringBuilder numbers = new StringBuilder();
    text.chars().forEach(c -> numbers.append(c).append(' '));
    return numbers.append(';').toString();
  }

  @Test
  void passesEveryTextUnchanged() throws Exception {
    StringBuilder received = new StringBuilder();
    for (int i = 0; i < HOSTILE.size(); i++) {
      properties.put("%02d".formatted(i) + HOSTILE.get(i), HOSTILE.get(i));
    }
    properties.forEach((name, value) -> received.append(numbers(name)).append(numbers(value)));
    for (String text : HOSTILE) {
      before.add("Say(\"" + text.replace("\\", "\\\\").replace("\"", "\\\"") + "\")");
      received.append(numbers(text));
    }
    received.append(numbers("hello"));
    description = String.join(" ", HOSTILE);
    source = String.join(" ", HOSTILE);
    TestApplication application = generate();
    HarnessBuild build = new HarnessBuild(folder);
    build.compile(application);
    List<String> lines = build.run(application);
    assertThat(lines).hasSize(1);
    assertThat(lines.get(0))
        .contains("outcome=\"RETURNED\"")
        .contains("<actual name=\"return\">" + received + "</actual>");
  }

  @Test
  void aDescriptionDoesNotLeaveItsComment() throws Exception {
    for (int i = 0; i < HOSTILE.size(); i++) {
      description = HOSTILE.get(i);
      Path subfolder = Files.createDirectory(folder.resolve("d" + i));
      new HarnessBuild(subfolder).compile(generate());
    }
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        " ",
        "a b",
        "a-b",
        "1a",
        "a;b",
        "a(",
        "a\"b",
        "a\\u0022",
        "a\nb",
        "a//b",
        "a/*",
        "{{x}}",
        "a\u0000b",
        "a\u200bb",
        "a\u00adb",
        "class",
        "int",
        "null",
        "_",
        "true"
      })
  void rejectsNamesThatAreNotJavaIdentifiers(String name) {
    method = name;
    assertThatThrownBy(this::generate).as("method").isInstanceOf(InvalidInputException.class);
    method = "Say";
    className = "robot." + name;
    assertThatThrownBy(this::generate).as("class").isInstanceOf(InvalidInputException.class);
    className = name + ".Echo";
    assertThatThrownBy(this::generate).as("package").isInstanceOf(InvalidInputException.class);
    className = "robot.Echo";
    required = List.of(new InterfaceDescription(name, List.of(), "r.xml"));
    assertThatThrownBy(this::generate).as("interface").isInstanceOf(InvalidInputException.class);
    Method named = new Method(name, STRING, List.of(), CallType.BLOCKING, 1);
    required = List.of(new InterfaceDescription("Finder", List.of(named), "r.xml"));
    assertThatThrownBy(this::generate).as("required").isInstanceOf(InvalidInputException.class);
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "a b", "1a", "a;b", "a\\u0022", "a\nb", "int x, int", "a\u200bb"})
  void aParameterMustBeAnIdentifier(String name) {
    parameter = name;
    assertThatThrownBy(this::generate).isInstanceOf(InvalidInputException.class);
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "class",
        "String",
        "int",
        "component",
        "result",
        "testCase",
        "returned",
        "org",
        "robot",
        "Component",
        "stopwatch",
        "call",
        "한글",
        "IRSensor",
        "ID",
        "var",
        "record",
        "_"
      })
  void aParameterMayHaveAnyNameUsedInTheSource(String name) throws Exception {
    parameter = name;
    new HarnessBuild(folder).compile(generate());
  }

  @ParameterizedTest
  @ValueSource(strings = {"class", "1st", "a-b.c", "../up", "Ünïcode", "a;b"})
  void aModelOfAnyNameHasItsOwnPackage(String name) throws Exception {
    modelName = name;
    TestApplication application = generate();
    assertThat(application.entryPoint())
        .matches("sitaf\\.harness\\.[a-z0-9_]+\\.ConcreteTestDriver");
    new HarnessBuild(folder).compile(application);
  }

  @ParameterizedTest
  @ValueSource(strings = {"String", "Object", "TestStub", "Out"})
  void rejectsARequiredInterfaceThatHidesATypeOfTheSources(String name) {
    required = List.of(new InterfaceDescription(name, List.of(), "r.xml"));
    assertThatThrownBy(this::generate)
        .isInstanceOf(InvalidInputException.class)
        .hasMessageContaining("rename the interface");
  }

  @ParameterizedTest
  @ValueSource(strings = {"wait", "getClass", "toString"})
  void rejectsARequiredMethodOfClassObject(String name) {
    Method named = new Method(name, STRING, List.of(), CallType.BLOCKING, 1);
    required = List.of(new InterfaceDescription("Finder", List.of(named), "r.xml"));
    assertThatThrownBy(this::generate).isInstanceOf(InvalidInputException.class);
  }
}
