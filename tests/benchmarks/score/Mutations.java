import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Mutations of Java source: one operator, constant, returned value or statement each. They know
 * nothing of interfaces, so they are independent of the faults that the score injects.
 */
final class Mutations {
  private static final Pattern CODE =
      Pattern.compile(
          "/\\*.*?\\*/|//[^\\n]*|\"[^\"]*\"|<=|>=|==|!=|\\|\\||&&|\\+\\+|\\+=|(?<=\\w )[<>](?= \\w)|(?<=[\\w)] )[-+*/](?= \\w)"
              + "|(?<![\\w.])\\d+(?:\\.\\d+)?(?!\\w)|(?<=return )[^;]+(?=;)|(?<=\\n)\\s+[\\w.]+\\([^;{}]*\\);|(?<=\\n)\\s+this\\.\\w+ = [^;]+;",
          Pattern.DOTALL);

  private static final Map<String, List<String>> OPERATORS =
      Map.ofEntries(
          Map.entry("<", List.of("<=", ">", ">=", "==", "!=")),
          Map.entry(">", List.of(">=", "<", "<=", "==", "!=")),
          Map.entry("<=", List.of("<", ">", ">=", "==", "!=")),
          Map.entry(">=", List.of(">", "<", "<=", "==", "!=")),
          Map.entry("==", List.of("!=")),
          Map.entry("!=", List.of("==")),
          Map.entry("||", List.of("&&")),
          Map.entry("&&", List.of("||")),
          Map.entry("+", List.of("-", "*")),
          Map.entry("-", List.of("+", "*")),
          Map.entry("*", List.of("+", "/")),
          Map.entry("/", List.of("*", "-")));

  private Mutations() {}

  /** All mutations of a source, in an order that depends on the seed only. */
  static List<String> of(String source, long seed) {
    List<String> mutants = new ArrayList<>();
    Matcher found = CODE.matcher(source);
    for (int from = 0; found.find(from); from = Math.max(found.start() + 1, skipped(found))) {
      for (String changed : changes(found.group())) {
        mutants.add(source.substring(0, found.start()) + changed + source.substring(found.end()));
      }
    }
    Collections.shuffle(mutants, new Random(seed));
    return mutants;
  }

  /** Operators within a returned value or a statement are mutated, too. */
  private static int skipped(Matcher found) {
    String text = found.group();
    boolean nested = !text.startsWith("/") && !text.startsWith("\"") && text.length() > 3 && !isNumber(text);
    return nested ? found.start() + 1 : found.end();
  }

  private static boolean isNumber(String text) {
    return Character.isDigit(text.charAt(0));
  }

  private static List<String> changes(String text) {
    List<String> operators = OPERATORS.get(text);
    if (operators != null) {
      return operators;
    }
    if (text.startsWith("/") || text.startsWith("\"") || text.startsWith("+")) {
      return List.of();
    }
    if (isNumber(text) && !text.contains("(")) {
      String real = text.contains(".") ? ".0" : "";
      long number = (long) Double.parseDouble(text);
      return List.of(
          (number + 1) + real, (number - 1) + real, "-" + (number + 2) + real, (number + 10) + real);
    }
    if (text.endsWith(";")) {
      return List.of("");
    }
    return List.of("0", "-1.0", "1", "(" + text + ") + 1", "-(" + text + ")", "(" + text + ") * 2", "Double.NaN", "(" + text + ") - 0.25", "2.5", "10");
  }
}
