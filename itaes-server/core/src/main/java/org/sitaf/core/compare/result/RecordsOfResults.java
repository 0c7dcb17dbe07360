package org.sitaf.core.compare.result;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.Value;
import org.sitaf.core.verdict.CaseRecord;
import org.sitaf.core.verdict.CaseRecord.Outcome;
import org.sitaf.core.verdict.CaseResult;
import org.sitaf.core.verdict.NamedValue;
import org.sitaf.core.verdict.StepRecord;
import org.sitaf.core.verdict.StepResult;
import org.sitaf.core.verdict.StubCalls;
import org.sitaf.core.verdict.Verdict;

/**
 * What the test applications recorded, as far as two results of a case tell it. An exception that
 * was expected has no message in a result: then the messages of both are left out.
 */
final class RecordsOfResults {
  /** Messages of cases that returned, but could not be judged. */
  private static final Pattern NOT_JUDGED =
      Pattern.compile(
          "\\A(?:post-condition |trajectory conditions |the expected value could not be evaluated"
              + "|the test application recorded no value of "
              + "|relation '|[^\\n]{1,300}: cannot be (?:evaluated|checked): )");

  /** The beginning of a message that is that of an exception: {@code robot.BadInput: }. */
  private static final Pattern EXCEPTION =
      Pattern.compile(
          "\\A(?:[A-Za-z_$][\\w$]{0,200}(?:\\.|::)){0,40}([A-Za-z_$][\\w$]{0,200})(?=: | at |\\z)");

  private static final Pattern AROUND_STEPS =
      Pattern.compile("\\A(?:before the first|after the last) step: ");

  private final TestModel model;

  RecordsOfResults(TestModel model) {
    this.model = model;
  }

  /** The records of a case in both results. */
  record Pair(CaseRecord base, CaseRecord now) {}

  Pair of(CaseResult base, CaseResult now) {
    if (!base.steps().isEmpty() || !now.steps().isEmpty()) {
      return ofSequences(base, now);
    }
    return withoutLostMessage(record(base), record(now));
  }

  private Pair ofSequences(CaseResult base, CaseResult now) {
    List<StepRecord> ofBase = new ArrayList<>();
    List<StepRecord> ofNow = new ArrayList<>();
    for (int i = 0; i < Math.max(base.steps().size(), now.steps().size()); i++) {
      StepRecord left = step(base, i);
      StepRecord right = step(now, i);
      if (left != null && right != null) {
        Pair both = withoutLostMessage(left.record(), right.record());
        left = left.with(both.base());
        right = right.with(both.now());
      }
      if (left != null) {
        ofBase.add(left);
      }
      if (right != null) {
        ofNow.add(right);
      }
    }
    return new Pair(sequence(base).with(ofBase), sequence(now).with(ofNow));
  }

  /** The record of a step; null if it was not executed. */
  private @Nullable StepRecord step(CaseResult result, int index) {
    if (index >= result.steps().size()) {
      return null;
    }
    StepResult step = result.steps().get(index);
    if (step.verdict() == Verdict.DONT && step.at() == null) {
      return null;
    }
    long at = step.at() == null ? -1 : Math.round(step.at() * 1e9);
    return new StepRecord(
        index + 1,
        step.name(),
        at,
        record(
            result.no(),
            step.verdict(),
            step.actual(),
            StubCalls.NONE,
            step.time(),
            step.message()));
  }

  /** A sequence as a whole: its steps have the values. */
  private static CaseRecord sequence(CaseResult result) {
    Matcher around = AROUND_STEPS.matcher(result.message());
    boolean failed = result.verdict() == Verdict.ERROR && around.find();
    boolean executed = result.steps().stream().anyMatch(s -> s.verdict() != Verdict.DONT);
    Outcome outcome =
        failed
            ? Outcome.ERROR
            : result.verdict() == Verdict.DONT && !executed ? Outcome.NOT_CALLED : Outcome.RETURNED;
    String message =
        outcome == Outcome.RETURNED
            ? ""
            : failed ? result.message().substring(around.end()) : result.message();
    return new CaseRecord(
        result.no(), outcome, "", List.of(), result.calls(), result.time(), message);
  }

  private CaseRecord record(CaseResult result) {
    return record(
        result.no(),
        result.verdict(),
        result.actual(),
        result.calls(),
        result.time(),
        result.message());
  }

  private CaseRecord record(
      int no,
      Verdict verdict,
      List<NamedValue> actual,
      StubCalls calls,
      CaseResult.@Nullable ProcessingTime time,
      String message) {
    String thrown =
        actual.stream()
            .map(NamedValue::literal)
            .filter(literal -> literal.startsWith(Value.ERROR_PREFIX))
            .findFirst()
            .map(literal -> literal.substring(Value.ERROR_PREFIX.length()))
            .orElse("");
    if (verdict == Verdict.DONT) {
      return new CaseRecord(no, Outcome.NOT_CALLED, "", List.of(), calls, time, message);
    }
    if (!thrown.isEmpty()) {
      return new CaseRecord(no, Outcome.THREW, thrown, List.of(), calls, time, "");
    }
    if (verdict != Verdict.ERROR || !actual.isEmpty() || NOT_JUDGED.matcher(message).find()) {
      return new CaseRecord(no, Outcome.RETURNED, "", named(actual), calls, time, "");
    }
    Matcher exception = EXCEPTION.matcher(message);
    return exception.find()
        ? new CaseRecord(no, Outcome.THREW, exception.group(1), List.of(), calls, time, message)
        : new CaseRecord(no, Outcome.ERROR, "", List.of(), calls, time, message);
  }

  /** A result omits the name of a single output. */
  private List<NamedValue> named(List<NamedValue> actual) {
    if (actual.size() != 1 || !actual.get(0).output().isEmpty()) {
      return actual;
    }
    String name =
        model.outputs().size() == 1 ? model.outputs().get(0).name() : OutputElement.RETURN_NAME;
    return List.of(new NamedValue(name, actual.get(0).literal()));
  }

  private static Pair withoutLostMessage(CaseRecord base, CaseRecord now) {
    boolean lost =
        base.outcome() == Outcome.THREW
            && now.outcome() == Outcome.THREW
            && base.message().isEmpty() != now.message().isEmpty();
    return lost ? new Pair(withoutMessage(base), withoutMessage(now)) : new Pair(base, now);
  }

  private static CaseRecord withoutMessage(CaseRecord record) {
    return new CaseRecord(
        record.no(),
        record.outcome(),
        record.thrown(),
        record.actual(),
        record.calls(),
        record.time(),
        "");
  }
}
