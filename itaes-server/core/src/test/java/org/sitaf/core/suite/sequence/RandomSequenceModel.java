package org.sitaf.core.suite.sequence;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.Set;
import org.sitaf.core.suite.TestCase;
import org.sitaf.core.suite.TestStep;
import org.sitaf.core.suite.TestSuite;

/**
 * A random model with guards, and an independent check of its suite by enumeration of all
 * sequences. Shares no code with the generator: states are pairs of a boolean and a counter.
 */
final class RandomSequenceModel {
  /** Values of the only input: 1 to 3 are valid. */
  private static final List<Integer> VALID = List.of(1, 2, 3);

  private static final int INVALID = 9;

  private final int length;
  private final int order;
  private final boolean repeat;
  private final List<Kind> kinds = new ArrayList<>();

  private record State(boolean on, int count) {}

  /**
   * A kind of step.
   *
   * @param needsOn the guard: 0 none, 1 on, 2 off, 3 count at least 1
   * @param effect the update: 0 none, 1 on, 2 off, 3 count + 1 up to 2, 4 on if the input is above
   *     1, 5 count becomes the input
   * @param failsAt input for which the call is expected to fail, which leaves the state; 0 for none
   */
  private record Kind(
      String name, int needsOn, int effect, boolean forbidden, boolean hasInput, int failsAt) {}

  RandomSequenceModel(long seed) {
    Random random = new Random(seed);
    int count = 2 + random.nextInt(3);
    length = 2 + random.nextInt(4);
    order = 1 + random.nextInt(Math.min(3, length));
    repeat = count < order || random.nextInt(4) > 0;
    for (int k = 0; k < count; k++) {
      boolean hasInput = random.nextInt(3) == 0;
      int needsOn = k == 0 ? 0 : random.nextInt(4);
      int effect = k == 0 ? 1 : random.nextInt(hasInput ? 6 : 4);
      kinds.add(
          new Kind(
              "s" + k,
              needsOn,
              effect,
              needsOn > 0 && random.nextBoolean(),
              hasInput,
              hasInput && random.nextInt(3) == 0 ? 2 : 0));
    }
  }

  String xml() {
    StringBuilder xml = new StringBuilder();
    xml.append("<test_model><name>R</name><input_spec_list/>\n<sequence_spec length=\"")
        .append(length)
        .append("\" order=\"")
        .append(order)
        .append("\" repeat=\"")
        .append(repeat)
        .append("\">\n<state name=\"on\" type=\"boolean\" initial=\"false\"/>")
        .append("<state name=\"count\" type=\"int\" initial=\"0\"/>\n");
    for (Kind kind : kinds) {
      xml.append("<call name=\"").append(kind.name).append("\">");
      xml.append(
          switch (kind.needsOn) {
            case 1 -> "<guard>on</guard>";
            case 2 -> "<guard>!on</guard>";
            case 3 -> "<guard>count &gt;= 1</guard>";
            default -> "";
          });
      xml.append(
          switch (kind.effect) {
            case 1 -> "<update state=\"on\">true</update>";
            case 2 -> "<update state=\"on\">false</update>";
            case 3 -> "<update state=\"count\">count &lt; 2 ? count + 1 : count</update>";
            case 4 -> "<update state=\"on\">x &gt; 1</update>";
            case 5 -> "<update state=\"count\">x</update>";
            default -> "";
          });
      if (kind.forbidden) {
        xml.append("<forbidden>!error:No</forbidden>");
      }
      if (kind.hasInput) {
        xml.append(
            "<input_spec_list><test_element abstract_type=\"NUMERIC\" real_type=\"int\">"
                + "<name>x</name><type>TDI</type><test_spec type=\"ECP\"><equiv_class"
                + " type=\"NEC_NUMERIC_SET\"><value>1</value><value>2</value><value>3</value>"
                + "</equiv_class></test_spec><user_value_list><value>1</value><value>2</value>"
                + "<value>3</value><value>9</value></user_value_list></test_element>"
                + "</input_spec_list>");
      }
      if (kind.failsAt > 0) {
        xml.append(
            "<output_spec_list><test_element abstract_type=\"NUMERIC\" real_type=\"int\">"
                + "<name>return</name><type>RETURN</type><expected>x == 2 ? \"!error:Two\" :"
                + " \"!any\"</expected></test_element></output_spec_list>");
      }
      xml.append("</call>\n");
    }
    return xml.append("</sequence_spec><order_of_combinations>1</order_of_combinations>")
        .append("</test_model>")
        .toString();
  }

  private static boolean allows(Kind kind, State state) {
    return switch (kind.needsOn) {
      case 1 -> state.on;
      case 2 -> !state.on;
      case 3 -> state.count >= 1;
      default -> true;
    };
  }

  private static State after(Kind kind, State state, int x) {
    if (kind.failsAt > 0 && x == kind.failsAt) {
      return state;
    }
    return switch (kind.effect) {
      case 1 -> new State(true, state.count);
      case 2 -> new State(false, state.count);
      case 3 -> new State(state.on, Math.min(2, state.count + 1));
      case 4 -> new State(x > 1, state.count);
      case 5 -> new State(state.on, x);
      default -> state;
    };
  }

  /** Tuples that some sequence contains, and those after which a forbidden call is possible. */
  private final class Enumeration {
    private final Set<List<Integer>> allowed = new HashSet<>();
    private final Map<Integer, Set<List<Integer>>> beforeForbidden = new HashMap<>();
    private final Set<Integer> ever = new HashSet<>();

    void explore(List<Integer> word, State state) {
      collect(word, order, allowed);
      for (int k = 0; k < kinds.size(); k++) {
        Kind kind = kinds.get(k);
        boolean isNew = repeat || !word.contains(k);
        if (word.size() >= length || !isNew) {
          continue;
        }
        if (!allows(kind, state)) {
          if (kind.forbidden) {
            collect(word, order - 1, beforeForbidden.computeIfAbsent(k, x -> new HashSet<>()));
          }
          continue;
        }
        ever.add(k);
        Set<State> next = new HashSet<>();
        for (int x : kind.hasInput ? VALID : List.of(0)) {
          next.add(after(kind, state, x));
        }
        List<Integer> longer = new ArrayList<>(word);
        longer.add(k);
        next.forEach(s -> explore(longer, s));
      }
    }
  }

  private static void collect(List<Integer> word, int size, Set<List<Integer>> into) {
    collect(word, 0, new ArrayList<>(), size, into);
  }

  private static void collect(
      List<Integer> word, int from, List<Integer> chosen, int left, Set<List<Integer>> into) {
    if (left == 0) {
      into.add(List.copyOf(chosen));
      return;
    }
    for (int i = from; i < word.size(); i++) {
      chosen.add(word.get(i));
      collect(word, i + 1, chosen, left - 1, into);
      chosen.remove(chosen.size() - 1);
    }
  }

  private Enumeration enumerate() {
    Enumeration all = new Enumeration();
    all.explore(List.of(), new State(false, 0));
    return all;
  }

  /** Whether each kind of step is possible in some sequence; otherwise the model is refused. */
  boolean isPossible() {
    return enumerate().ever.size() == kinds.size();
  }

  /** The first violation of the contract; empty if there is none. */
  String violation(TestSuite suite) {
    Enumeration all = enumerate();
    Set<List<Integer>> covered = new HashSet<>();
    Map<Integer, Set<List<Integer>>> forbidden = new HashMap<>();
    Set<String> usedRows = new HashSet<>();
    Map<String, Integer> invalidRows = new HashMap<>();
    for (TestCase testCase : suite.cases()) {
      List<Integer> word = new ArrayList<>();
      State state = new State(false, 0);
      State other = state;
      int invalid = 0;
      if (testCase.steps().isEmpty() || testCase.steps().size() > length) {
        return "case " + testCase.no() + " has " + testCase.steps().size() + " steps";
      }
      for (int i = 0; i < testCase.steps().size(); i++) {
        TestStep step = testCase.steps().get(i);
        int k = Integer.parseInt(step.name().substring(1));
        Kind kind = kinds.get(k);
        String where = "case " + testCase.no() + ", step " + (i + 1) + ": ";
        if (!repeat && word.contains(k)) {
          return where + "repeats " + step.name();
        }
        int x = kind.hasInput ? Integer.parseInt(step.values().get(0)) : 0;
        boolean isInvalidRow = kind.hasInput && !VALID.contains(x);
        boolean isAllowed = allows(kind, state) && allows(kind, other);
        if (step.valid() && (!isAllowed || isInvalidRow)) {
          return where + step.name() + " is not allowed in " + state + " or " + other;
        }
        if (!step.valid()) {
          invalid++;
          if (!isAllowed) {
            if (isInvalidRow || !kind.forbidden) {
              return where + "a forbidden call with an invalid row, or without forbidden";
            }
            if (step.expected().size() != 1
                || !step.expected().get(0).literal().equals("!error:No")) {
              return where + "expects " + step.expected();
            }
            collect(word, order - 1, forbidden.computeIfAbsent(k, f -> new HashSet<>()));
          } else {
            if (!isInvalidRow) {
              return where + step.name() + " is neither forbidden nor invalid";
            }
            invalidRows.merge(step.name() + "=" + x, 1, Integer::sum);
            other = after(kind, state, x);
          }
        } else {
          if (kind.hasInput && testCase.valid()) {
            usedRows.add(step.name() + x);
          }
          state = after(kind, state, x);
          other = invalid > 0 ? after(kind, other, x) : state;
        }
        word.add(k);
      }
      if (invalid > 1 || (invalid == 0) != testCase.valid()) {
        return "case " + testCase.no() + " has " + invalid + " invalid steps";
      }
      if (testCase.valid()) {
        collect(word, order, covered);
      }
    }
    if (invalidRows.values().stream().anyMatch(uses -> uses != 1)) {
      return "an invalid row is used several times: " + invalidRows;
    }
    if (!covered.equals(all.allowed)) {
      Set<List<Integer>> missing = new HashSet<>(all.allowed);
      missing.removeAll(covered);
      covered.removeAll(all.allowed);
      return "missing tuples " + missing + ", impossible tuples " + covered;
    }
    for (int k = 0; k < kinds.size(); k++) {
      Set<List<Integer>> wanted = all.beforeForbidden.getOrDefault(k, Set.of());
      if (!forbidden.getOrDefault(k, Set.of()).containsAll(wanted)) {
        return "the forbidden s" + k + " is not made after all of " + wanted;
      }
      Kind kind = kinds.get(k);
      if (kind.hasInput) {
        for (int x : VALID) {
          if (!usedRows.contains(kind.name + x)) {
            return "the row " + x + " of " + kind.name + " is not used";
          }
        }
        if (!invalidRows.containsKey(kind.name + "=" + INVALID)) {
          return "the invalid row of " + kind.name + " is not used";
        }
      }
    }
    return "";
  }
}
