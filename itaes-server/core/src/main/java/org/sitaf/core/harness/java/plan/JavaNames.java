package org.sitaf.core.harness.java.plan;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.harness.plan.DeclaredNames;
import org.sitaf.core.harness.plan.Words;

/**
 * Names in Java sources. Names of methods and interfaces are taken from the user's documents and
 * rejected if invalid in Java; types, members and local variables are renamed if necessary.
 */
final class JavaNames {
  private static final Set<String> KEYWORDS =
      words(
          """
          abstract assert boolean break byte case catch char class const continue default do double else enum extends
          false final finally float for goto if implements import instanceof int interface long native new null package
          private protected public return short static strictfp super switch synchronized this throw throws transient
          true try void volatile while _\
          """);

  /** Not keywords, but not allowed as type names. */
  private static final Set<String> RESTRICTED = words("var yield record sealed permits");

  /** Types that generated sources use by simple name. */
  private static final Set<String> USED_TYPES =
      words(
          """
          Answers BigInteger Boolean Byte NonblockingCall CaseResult Character ConcreteTestDriver Double Duration
          Exception Float Integer LifeCycle LinkedHashMap Long Map Object Out Override RuntimeException Short
          Simulation SimulationControl Stopwatch String StubbedMethod StubbedOut Stubbing SuiteDriver TestCase
          TestDriver TestRun TestStub Tick Void\
          """);

  /** Methods of Object, which an interface cannot redeclare. */
  private static final Set<String> OBJECT_METHODS =
      words("clone equals finalize getClass hashCode notify notifyAll toString wait");

  /**
   * Local variables of generated methods, and first parts of qualified names, which a local
   * variable would hide.
   */
  private static final Set<String> USED_LOCALS =
      words(
          """
          answer args component java javax org parameters pending result returned run simulation simulationControl sitaf
          stopwatch stubbing testCase testStub\
          """);

  /** The names of the interfaces' types. */
  static final DeclaredNames DECLARED =
      new DeclaredNames(
          "Java",
          name -> isTypeName(name) && !isUsedType(name),
          name -> isName(name) && !isObjectMethod(name),
          JavaNames::isName);

  private final Set<String> taken = new HashSet<>(USED_LOCALS);

  /** Creates the names of one scope. */
  JavaNames(String... alsoTaken) {
    taken.addAll(Arrays.asList(alsoTaken));
  }

  private static Set<String> words(String text) {
    return Arrays.stream(text.split("\\s+")).collect(Collectors.toUnmodifiableSet());
  }

  /** Whether a name is valid for a method or a variable. */
  static boolean isName(String name) {
    return Words.isWord(name) && !KEYWORDS.contains(name);
  }

  /** Whether a name is valid for a type. */
  static boolean isTypeName(String name) {
    return isName(name) && !RESTRICTED.contains(name);
  }

  /** Whether a simple type name conflicts with the names in generated sources. */
  static boolean isUsedType(String simpleName) {
    return USED_TYPES.contains(simpleName) || USED_LOCALS.contains(simpleName);
  }

  /** Whether Object has a method of this name. */
  static boolean isObjectMethod(String name) {
    return OBJECT_METHODS.contains(name);
  }

  /**
   * The last part of the package of a model: its name in lower case, with invalid characters
   * replaced.
   */
  static String packagePart(String modelName) {
    String part = modelName.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9_]", "_");
    if (part.isEmpty() || Character.isDigit(part.charAt(0))) {
      part = "_" + part;
    }
    return KEYWORDS.contains(part) ? part + "_" : part;
  }

  /**
   * A unique name of a local variable: {@code IndexOfSensor} becomes {@code indexOfSensor}, {@code
   * Finder.GetRange} becomes {@code finderGetRange}.
   */
  String local(String documentName) {
    String wanted = Words.camelCase(documentName.split("[^\\p{L}\\p{Nd}_$]+"));
    String name = isName(wanted) && !RESTRICTED.contains(wanted) ? wanted : wanted + "Value";
    for (int i = 2; !taken.add(name); i++) {
      name = wanted + "Value" + (i == 2 ? "" : i - 1);
    }
    return name;
  }
}
