package org.sitaf.core.harness.cpp.syntax;

import java.util.Arrays;
import java.util.HashSet;
import java.util.Locale;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sitaf.core.harness.plan.DeclaredNames;
import org.sitaf.core.harness.plan.Words;

/**
 * Names in C++ sources. Names of methods and interfaces are taken from the user's documents and
 * rejected if invalid in C++; types, members and local variables are renamed if necessary.
 */
public final class CppNames {
  private static final Pattern NAME = Pattern.compile("[A-Za-z_][A-Za-z0-9_]*");

  private static final Set<String> KEYWORDS =
      words(
          """
          alignas alignof and and_eq asm atomic_cancel atomic_commit atomic_noexcept auto bitand bitor bool break case
          catch char char8_t char16_t char32_t class compl concept const consteval constexpr constinit const_cast
          continue co_await co_return co_yield decltype default delete do double dynamic_cast else enum explicit export
          extern false float for friend goto if inline int long mutable namespace new noexcept not not_eq nullptr
          operator or or_eq private protected public reflexpr register reinterpret_cast requires return short signed
          sizeof static static_assert static_cast struct switch synchronized template this thread_local throw true try
          typedef typeid typename union unsigned using virtual void volatile wchar_t while xor xor_eq\
          """);

  /** Macros of the headers that test applications include. */
  private static final Set<String> MACROS =
      words(
          """
          BUFSIZ CHAR_BIT CHAR_MAX CHAR_MIN EDOM EILSEQ EOF ERANGE EXIT_FAILURE EXIT_SUCCESS FLT_MAX FLT_MIN HUGE_VAL
          INFINITY INT_MAX INT_MIN L_tmpnam LONG_MAX LONG_MIN MATH_ERREXCEPT NAN NDEBUG NULL RAND_MAX SEEK_CUR SEEK_END
          SEEK_SET SITAF_MEMBER SITAF_METHOD SITAF_SETTER SIZE_MAX UINT_MAX assert errno i386 linux major minor makedev offsetof
          setjmp signals slots stderr stdin stdout unix va_arg va_copy va_end va_start\
          """);

  /** Types and namespaces that generated sources use by simple name. */
  private static final Set<String> USED_TYPES =
      words(
          """
          Component ConcreteTestDriver SimulationControl TestDriver TestStub harness interfaces runtime simulation
          sitaf std suite\
          """);

  /** Local variables and members of generated code, and first parts of qualified names. */
  private static final Set<String> USED_LOCALS =
      words(
          """
          actual afterCase argc argv beforeCase begin call callNonblocking component execute interfaces main pending prepare
          raise result returned run runtime save simulation simulationControl sitaf std stopwatch stubbing suite
          testCase testStub value\
          """);

  /** The names of the interfaces' types. */
  public static final DeclaredNames DECLARED =
      new DeclaredNames("C++", CppNames::isTypeName, CppNames::isName, CppNames::isName);

  private final Set<String> taken = new HashSet<>(USED_LOCALS);

  private static Set<String> words(String text) {
    return Arrays.stream(text.split("\\s+")).collect(Collectors.toUnmodifiableSet());
  }

  /** Whether a name is valid for a method, a member or a literal. */
  public static boolean isName(String name) {
    return NAME.matcher(name).matches()
        && !KEYWORDS.contains(name)
        && !MACROS.contains(name)
        // Reserved for the compiler.
        && !name.contains("__")
        && !name.matches("_[A-Z].*");
  }

  /** Whether a name is valid for a type and does not conflict with generated sources. */
  public static boolean isTypeName(String name) {
    return isName(name) && !USED_TYPES.contains(name);
  }

  /** Whether a qualified class name is valid. */
  public static boolean isQualifiedName(String name) {
    return Arrays.stream(name.split("::", -1)).allMatch(CppNames::isName);
  }

  /**
   * The innermost namespace and the folder of a model's test application: the model's name in lower
   * case, with invalid characters replaced.
   */
  public static String namespace(String modelName) {
    String part = modelName.toLowerCase(Locale.ROOT).replaceAll("[^a-z0-9]+", "_");
    if (part.isEmpty() || !Character.isLetter(part.charAt(0))) {
      part = "model" + (part.startsWith("_") ? "" : "_") + part;
    }
    return isTypeName(part) ? part : part + "_model";
  }

  /**
   * A unique name of a local variable: {@code IndexOfSensor} becomes {@code indexOfSensor}, {@code
   * Finder.GetRange} becomes {@code finderGetRange}.
   */
  public String local(String documentName) {
    String joined = Words.camelCase(documentName.split("[^A-Za-z0-9]+"));
    String wanted =
        joined.isEmpty() || Character.isDigit(joined.charAt(0)) ? "value" + joined : joined;
    String name = isName(wanted) ? wanted : wanted + "Value";
    for (int i = 2; !taken.add(name); i++) {
      name = wanted + "Value" + (i == 2 ? "" : i - 1);
    }
    return name;
  }

  /** Reserves a name, so it is not used for a local variable. */
  public void take(String name) {
    taken.add(name);
  }
}
