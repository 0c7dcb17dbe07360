package org.sitaf.core.harness.python;

import java.text.Normalizer;
import java.util.Arrays;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sitaf.core.harness.plan.DeclaredNames;
import org.sitaf.core.harness.plan.Words;

/**
 * Names in Python sources. Names of methods and interfaces are taken from the user's documents and
 * rejected if invalid in Python; types, members and local variables are renamed if necessary.
 */
final class PythonNames {
  private static final Set<String> KEYWORDS =
      words(
          """
          False None True and as assert async await break class continue def del elif else except finally for from
          global if import in is lambda nonlocal not or pass raise return try while with yield\
          """);

  /** Names that generated modules use at the top level. */
  private static final Set<String> USED_TYPES =
      words(
          """
          Answer BOOLEAN CHARACTER CaseResult ConcreteTestDriver ERRORS Enum Exception FLOAT32 FLOAT64 INT16 INT32 INT64 INT8
          InOut NotImplementedError Out Protocol RUN_FOR SETTLE STRING Simulation SimulationControl StubbedMethod
          SuiteDriver TestCase TestDriver TestRun TestStub UINT16 UINT32 UINT64 UINT8 abstractmethod answer
          bool call_with_outs data_types dataclass dict enumeration errors float int list member method_of object
          part_of port_of sequence set_property start str struct super tuple type\
          """);

  /** Local variables of generated methods. */
  private static final Set<String> USED_LOCALS =
      words("component parameters pending result returned run self test_case");

  private static final Pattern BORDERS =
      Pattern.compile("(?<=[\\p{Ll}\\p{Nd}])(?=\\p{Lu})|(?<=\\p{Lu})(?=\\p{Lu}\\p{Ll})");

  /** The names of the interfaces' types. */
  static final DeclaredNames DECLARED =
      new DeclaredNames(
          "Python",
          PythonNames::isTypeName,
          PythonNames::isName,
          // A class of the enum module has underscored names of its own.
          name -> isName(name) && !name.startsWith("_"));

  private final Set<String> taken = new HashSet<>(USED_LOCALS);

  /** Creates the names of one scope. */
  PythonNames() {
    taken.addAll(USED_TYPES);
  }

  private static Set<String> words(String text) {
    return Arrays.stream(text.split("\\s+")).collect(Collectors.toUnmodifiableSet());
  }

  /**
   * Whether a name is valid. Excludes leading double underscores, which Python mangles in classes,
   * and names that Python would normalize.
   */
  static boolean isName(String name) {
    return Words.isWord(name)
        && !KEYWORDS.contains(name)
        && name.indexOf('$') < 0
        && !name.startsWith("__")
        && (name.charAt(0) == '_' || Character.isUnicodeIdentifierStart(name.charAt(0)))
        && Normalizer.isNormalized(name, Normalizer.Form.NFKC);
  }

  /** Whether a name is valid for a type and does not conflict with generated sources. */
  static boolean isTypeName(String name) {
    return isName(name) && !USED_TYPES.contains(name);
  }

  /** Whether a name is used by generated sources. */
  static boolean isUsedType(String name) {
    return USED_TYPES.contains(name);
  }

  /** The package of a model: its name in snake case, with invalid characters replaced. */
  static String packagePart(String modelName) {
    String part = snakeCase(modelName).replaceAll("[^a-z0-9_]", "_");
    if (part.isEmpty() || Character.isDigit(part.charAt(0)) || part.startsWith("__")) {
      part = "model_" + part;
    }
    return KEYWORDS.contains(part) ? part + "_" : part;
  }

  /**
   * Converts {@code IndexOfSensor} to {@code index_of_sensor} and {@code IRSensor} to {@code
   * ir_sensor}.
   */
  static String snakeCase(String name) {
    return BORDERS.matcher(name).replaceAll("_").toLowerCase(Locale.ROOT);
  }

  /** A unique name of a local variable for a name in a document. */
  String local(String documentName) {
    String wanted =
        snakeCase(documentName).replaceAll("[^\\p{L}\\p{Nd}_]+", "_").replaceAll("^_+|_+$", "");
    if (wanted.isEmpty() || Character.isDigit(wanted.charAt(0))) {
      wanted = "value_" + wanted;
    }
    String name = isName(wanted) ? wanted : wanted + "_";
    if (!isName(name)) {
      name = "value";
    }
    String first = name;
    for (int i = 2; !taken.add(name); i++) {
      name = first + "_" + i;
    }
    return name;
  }
}
