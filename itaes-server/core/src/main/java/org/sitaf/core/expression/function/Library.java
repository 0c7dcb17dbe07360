package org.sitaf.core.expression.function;

import static org.sitaf.core.expression.function.Signature.Kind.LIST;
import static org.sitaf.core.expression.function.Signature.Kind.NUMBER;
import static org.sitaf.core.expression.function.Signature.Kind.QUATERNION;
import static org.sitaf.core.expression.function.Signature.Kind.VALUE;
import static org.sitaf.core.expression.function.Signature.Kind.VECTOR;
import static org.sitaf.core.expression.function.Signature.Kind.WHOLE;
import static org.sitaf.core.expression.function.Signature.Result.BOOLEAN;
import static org.sitaf.core.expression.function.Signature.Result.FORM;
import static org.sitaf.core.expression.function.Signature.Result.LAST_FORM;
import static org.sitaf.core.expression.function.Signature.Result.MATRIX;
import static org.sitaf.core.expression.function.Signature.Result.REAL;
import static org.sitaf.core.expression.function.Signature.Result.SAME;

import dev.cel.runtime.CelFunctionBinding;
import dev.cel.runtime.CelFunctionOverload;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.function.DoubleBinaryOperator;
import java.util.function.DoubleUnaryOperator;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.hipparchus.util.FastMath;
import org.sitaf.core.expression.function.Signature.Cost;
import org.sitaf.core.expression.function.Signature.Kind;
import org.sitaf.core.expression.function.Signature.Result;

/** All functions and operators that SITAF adds to CEL. */
// The functions are method references without state.
@SuppressWarnings("Immutable")
public final class Library {
  /** Names of the operators over numbers, which replace those of CEL, by theirs. */
  public static final Map<String, String> OPERATORS =
      Map.ofEntries(
          Map.entry("_+_", "@add"),
          Map.entry("_-_", "@subtract"),
          Map.entry("_*_", "@multiply"),
          Map.entry("_/_", "@divide"),
          Map.entry("_%_", "@modulo"),
          Map.entry("-_", "@negate"),
          Map.entry("_<_", "@less"),
          Map.entry("_<=_", "@less_equals"),
          Map.entry("_>_", "@greater"),
          Map.entry("_>=_", "@greater_equals"),
          Map.entry("_==_", "@equals"),
          Map.entry("_!=_", "@not_equals"),
          Map.entry("@in", "@member"));

  private static final Library INSTANCE = new Library();

  private final Map<String, List<Signature>> signatures = new LinkedHashMap<>();
  private final Map<String, List<CelFunctionBinding>> bindings = new LinkedHashMap<>();

  private Library() {
    operators();
    scalars();
    angles();
    vectors();
    matrices();
    quaternions();
  }

  /** The signatures of a function; empty if there is no such function. */
  public static List<Signature> signatures(String function) {
    return INSTANCE.signatures.getOrDefault(function, List.of());
  }

  /** The names of all functions, in the order of the documentation. */
  public static List<String> names() {
    return List.copyOf(INSTANCE.signatures.keySet());
  }

  /** The bindings of all functions and operators. */
  public static List<CelFunctionBinding> bindings() {
    List<CelFunctionBinding> all = new ArrayList<>();
    INSTANCE.bindings.forEach(
        (name, overloads) -> all.addAll(CelFunctionBinding.fromOverloads(name, overloads)));
    return all;
  }

  /**
   * The implementation of an operator or function over numbers, which takes constant time; empty if
   * there is no such function.
   */
  public static Optional<CelFunctionOverload> ofScalars(String name, int arguments) {
    boolean constant =
        OPERATORS.containsValue(name)
            || signatures(name).stream()
                .anyMatch(
                    signature ->
                        signature.cost() == Cost.CONSTANT
                            && signature.parameters().size() == arguments);
    if (!constant) {
      return Optional.empty();
    }
    return INSTANCE.bindings.getOrDefault(name, List.of()).stream()
        .filter(binding -> binding.getArgTypes().size() == arguments)
        .map(CelFunctionBinding::getDefinition)
        .findFirst();
  }

  /** The implementation of {@code min} or {@code max}, whose argument is a list. */
  public static CelFunctionOverload ofNumbers(String name) {
    return INSTANCE.bindings.getOrDefault(name, List.of()).get(0).getDefinition();
  }

  private void operators() {
    bind2("@add", Arithmetic::add);
    bind2("@subtract", Arithmetic::subtract);
    bind2("@multiply", Arithmetic::multiply);
    bind2("@divide", Arithmetic::divide);
    bind2("@modulo", Arithmetic::modulo);
    bind1("@negate", Arithmetic::negate);
    bind2("@less", Comparisons::less);
    bind2("@less_equals", Comparisons::lessEquals);
    bind2("@greater", Comparisons::greater);
    bind2("@greater_equals", Comparisons::greaterEquals);
    bind2("@equals", Comparisons::equals);
    bind2("@not_equals", Comparisons::notEquals);
    bind2("@member", Comparisons::isMember);
  }

  private void scalars() {
    number("abs", Scalars::abs);
    sign(new Signature("min", List.of(LIST), SAME, Cost.PARTS));
    bind1("min", list -> Scalars.least(elements("min", list)));
    sign(new Signature("max", List.of(LIST), SAME, Cost.PARTS));
    bind1("max", list -> Scalars.greatest(elements("max", list)));
    sign(new Signature("clamp", List.of(NUMBER, NUMBER, NUMBER), SAME, Cost.CONSTANT));
    bindings
        .computeIfAbsent("clamp", n -> new ArrayList<>())
        .add(
            CelFunctionBinding.from(
                "clamp_3",
                List.of(Object.class, Object.class, Object.class),
                a -> Scalars.clamp(a[0], a[1], a[2])));
    number("sign", Scalars::sign);
    number("floor", Scalars::floor);
    number("ceil", Scalars::ceil);
    number("round", Scalars::round);
    real("sqrt", Math::sqrt);
    real("cbrt", StrictMath::cbrt);
    real("pow", StrictMath::pow);
    real("exp", FastMath::exp);
    real("log", StrictMath::log);
    real("log10", StrictMath::log10);
    real("hypot", StrictMath::hypot);
    real("sin", StrictMath::sin);
    real("cos", StrictMath::cos);
    real("tan", StrictMath::tan);
    real("asin", StrictMath::asin);
    real("acos", StrictMath::acos);
    real("atan", StrictMath::atan);
    real("atan2", StrictMath::atan2);
    real("sinh", StrictMath::sinh);
    real("cosh", StrictMath::cosh);
    real("tanh", StrictMath::tanh);
    sign(new Signature("is_finite", List.of(NUMBER), BOOLEAN, Cost.CONSTANT));
    bind1("is_finite", x -> Double.isFinite(Numbers.real(x)));
    sign(new Signature("is_nan", List.of(NUMBER), BOOLEAN, Cost.CONSTANT));
    bind1("is_nan", x -> Double.isNaN(Numbers.real(x)));
  }

  private void angles() {
    real("wrap_angle", Scalars::wrapAngle);
    real("angle_difference", (a, b) -> Scalars.wrapAngle(a - b));
    sign(new Signature("near", List.of(VALUE, VALUE, NUMBER), BOOLEAN, Cost.PARTS));
    sign(new Signature("near", List.of(VALUE, VALUE, NUMBER, NUMBER), BOOLEAN, Cost.PARTS));
    bindings.put(
        "near",
        List.of(
            CelFunctionBinding.from(
                "near_3",
                List.of(Object.class, Object.class, Object.class),
                a -> Nearness.near(a[0], a[1], a[2], 0L)),
            CelFunctionBinding.from(
                "near_4",
                List.of(Object.class, Object.class, Object.class, Object.class),
                a -> Nearness.near(a[0], a[1], a[2], a[3]))));
  }

  private void vectors() {
    sign(new Signature("sum", List.of(VECTOR), SAME, Cost.PARTS));
    bind1("sum", Vectors::sum);
    sign(new Signature("mean", List.of(VECTOR), REAL, Cost.PARTS));
    bind1("mean", Vectors::mean);
    sign(new Signature("norm", List.of(VECTOR), REAL, Cost.PARTS));
    bind1("norm", Vectors::norm);
    sign(new Signature("dot", List.of(VECTOR, VECTOR), SAME, Cost.PARTS));
    bind2("dot", Vectors::dot);
    sign(new Signature("cross", List.of(VECTOR, VECTOR), FORM, Cost.PARTS));
    bind2("cross", Vectors::cross);
    sign(new Signature("is_sorted", List.of(VECTOR), BOOLEAN, Cost.PARTS));
    bind1("is_sorted", Vectors::isSorted);
  }

  private void matrices() {
    sign(new Signature("matmul", List.of(Kind.MATRIX, Kind.MATRIX), MATRIX, Cost.PRODUCT));
    sign(new Signature("matmul", List.of(Kind.MATRIX, VECTOR), LAST_FORM, Cost.PRODUCT));
    bind2("matmul", Matrices::matmul);
    sign(new Signature("transpose", List.of(Kind.MATRIX), MATRIX, Cost.PARTS));
    bind1("transpose", Matrices::transpose);
    sign(new Signature("det", List.of(Kind.MATRIX), REAL, Cost.PRODUCT));
    bind1("det", Matrices::det);
    sign(new Signature("identity", List.of(WHOLE), MATRIX, Cost.PARTS));
    bind1("identity", Matrices::identity);
  }

  private void quaternions() {
    sign(new Signature("qmul", List.of(QUATERNION, QUATERNION), FORM, Cost.PARTS));
    bind2("qmul", Quaternions::product);
    sign(new Signature("qconj", List.of(QUATERNION), FORM, Cost.PARTS));
    bind1("qconj", Quaternions::conjugate);
    sign(new Signature("qnorm", List.of(QUATERNION), REAL, Cost.PARTS));
    bind1("qnorm", Quaternions::norm);
    sign(new Signature("qrotate", List.of(QUATERNION, VECTOR), LAST_FORM, Cost.PARTS));
    bind2("qrotate", Quaternions::rotate);
    sign(new Signature("qangle", List.of(QUATERNION, QUATERNION), REAL, Cost.PARTS));
    bind2("qangle", Quaternions::angle);
  }

  private static List<?> elements(String function, Object list) {
    if (list instanceof List<?> elements) {
      return elements;
    }
    throw new IllegalArgumentException(
        function + " needs two or more numbers or one list, not " + Numbers.shown(list));
  }

  /** A function whose result is whole for a whole number. */
  private void number(String name, UnaryOperator<Object> function) {
    sign(new Signature(name, List.of(NUMBER), SAME, Cost.CONSTANT));
    bind1(name, function);
  }

  private void real(String name, DoubleUnaryOperator function) {
    sign(new Signature(name, List.of(NUMBER), Result.REAL, Cost.CONSTANT));
    bind1(name, x -> function.applyAsDouble(Numbers.real(x)));
  }

  private void real(String name, DoubleBinaryOperator function) {
    sign(new Signature(name, List.of(NUMBER, NUMBER), Result.REAL, Cost.CONSTANT));
    bind2(name, (x, y) -> function.applyAsDouble(Numbers.real(x), Numbers.real(y)));
  }

  private void sign(Signature signature) {
    signatures.computeIfAbsent(signature.name(), n -> new ArrayList<>()).add(signature);
  }

  private void bind1(String name, Function<Object, Object> function) {
    bindings
        .computeIfAbsent(name, n -> new ArrayList<>())
        .add(CelFunctionBinding.from(name + "_1", Object.class, function::apply));
  }

  private void bind2(String name, BiFunction<Object, Object, Object> function) {
    bindings
        .computeIfAbsent(name, n -> new ArrayList<>())
        .add(CelFunctionBinding.from(name + "_2", Object.class, Object.class, function::apply));
  }
}
