package org.sitaf.core.harness.java.plan;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import org.sitaf.core.harness.plan.Words;

/**
 * Names of users' documents in Java sources. What is called must keep its name and is refused where
 * Java cannot spell it; locals are only named after something, and step aside.
 */
final class JavaNames {
  private static final Set<String> KEYWORDS =
      words(
          """
          abstract assert boolean break byte case catch char class const continue default do double else enum extends
          false final finally float for goto if implements import instanceof int interface long native new null package
          private protected public return short static strictfp super switch synchronized this throw throws transient
          true try void volatile while _""");

  /** Cannot name a type, though it is no keyword. */
  private static final Set<String> RESTRICTED = words("var yield record sealed permits");

  /** Types that generated sources use by their simple name. */
  private static final Set<String> USED_TYPES =
      words(
          """
          Answers BigInteger Boolean Byte CallBeside CaseResult Character ConcreteTestDriver Double Duration
          Exception Float Integer LifeCycle LinkedHashMap Long Map Object Out Override RuntimeException Short
          Simulation SimulationControl Stopwatch String StubbedMethod StubbedOut Stubbing SuiteDriver TestCase
          TestDriver TestRun TestStub Tick Void""");

  /** Methods that every object has: an interface cannot declare its own. */
  private static final Set<String> OBJECT_METHODS =
      words("clone equals finalize getClass hashCode notify notifyAll toString wait");

  /**
   * Locals of generated methods, and the first parts of qualified names, which a local would hide.
   */
  private static final Set<String> USED_LOCALS =
      words(
          """
          answer args component java javax org parameters pending result returned run simulation simulationControl sitaf
          stopwatch stubbing testCase testStub""");

  private final Set<String> taken = new HashSet<>(USED_LOCALS);

  /** Names of one scope. */
  JavaNames(String... alsoTaken) {
    taken.addAll(Arrays.asList(alsoTaken));
  }

  private static Set<String> words(String text) {
    return Arrays.stream(text.split("\\s+")).collect(Collectors.toUnmodifiableSet());
  }

  /** Whether Java spells a method or a variable so. */
  static boolean isName(String name) {
    return Words.isWord(name) && !KEYWORDS.contains(name);
  }

  /** Whether Java spells a type so. */
  static boolean isTypeName(String name) {
    return isName(name) && !RESTRICTED.contains(name);
  }

  /**
   * Whether generated sources mean something else by that simple name of a type; a local of that
   * name would hide it, too.
   */
  static boolean isUsedType(String simpleName) {
    return USED_TYPES.contains(simpleName) || USED_LOCALS.contains(simpleName);
  }

  /** Whether every object has a method of that name. */
  static boolean isObjectMethod(String name) {
    return OBJECT_METHODS.contains(name);
  }

  /**
   * A package's last part for a model: its name in lower case, with what Java cannot spell
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
   * A name for a local: {@code IndexOfSensor} gives {@code indexOfSensor}, {@code Finder.GetRange}
   * gives {@code finderGetRange}.
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
