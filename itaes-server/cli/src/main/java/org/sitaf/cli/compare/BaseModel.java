package org.sitaf.cli.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.Activity;
import org.sitaf.core.compare.NotComparable;
import org.sitaf.core.description.DataType;
import org.sitaf.core.description.MemberPath;
import org.sitaf.core.diagnostic.Diagnostic;
import org.sitaf.core.diagnostic.Severity;
import org.sitaf.core.model.OutputElement;
import org.sitaf.core.model.OutputKind;
import org.sitaf.core.model.TestModel;
import org.sitaf.core.model.document.TestModelXml;

/**
 * A model of the new version for the base version, which may lack outputs, types or the method.
 *
 * @param model null if the base version cannot run the model
 * @param judged whether the conditions and expected values of the model hold for the base version,
 *     too
 * @param notComparable what the base version lacks
 */
public record BaseModel(
    @Nullable TestModel model, boolean judged, List<NotComparable> notComparable) {
  public BaseModel {
    notComparable = List.copyOf(notComparable);
  }

  /** The part of a model that the base version has. */
  public static BaseModel of(Activity base, Activity now, TestModel model) {
    TestModel read =
        TestModelXml.read(now.files().open(model.source()).orElseThrow(), model.source());
    TestModel whole = base.resolve(read);
    List<NotComparable> lacking = onlyInBase(base, now, model);
    if (problem(base, whole).isEmpty()) {
      return new BaseModel(whole, true, lacking);
    }
    TestModel bare = base.resolve(read.withoutConditions().withOutputs(List.of()));
    Optional<String> fatal = problem(base, bare);
    if (fatal.isPresent()) {
      lacking.add(new NotComparable(model.name(), 0, "", "BASE: " + fatal.get()));
      return new BaseModel(null, false, lacking);
    }
    List<OutputElement> known = new ArrayList<>();
    for (OutputElement output : read.outputs()) {
      OutputElement unjudged = output.withoutExpected();
      Optional<String> unknown = problem(base, base.resolve(bare.withOutputs(List.of(unjudged))));
      if (unknown.isEmpty()) {
        known.add(unjudged);
      } else {
        lacking.add(new NotComparable(model.name(), 0, output.name(), "BASE: " + unknown.get()));
      }
    }
    return new BaseModel(base.resolve(bare.withOutputs(known)), false, lacking);
  }

  /**
   * The outputs of the model with the same name in the base version that are not recorded now:
   * return values and out-parameters are recorded, whether a model names them or not.
   */
  private static List<NotComparable> onlyInBase(Activity base, Activity now, TestModel model) {
    List<NotComparable> missing = new ArrayList<>();
    base.model(model.name()).stream()
        .flatMap(old -> old.outputs().stream())
        .filter(
            old ->
                old.kind() == OutputKind.OBSERVED
                    || now.outputType(model, MemberPath.root(old.name()))
                        instanceof DataType.Unknown)
        .map(OutputElement::name)
        .filter(name -> model.outputs().stream().noneMatch(o -> o.name().equals(name)))
        .forEach(
            name ->
                missing.add(
                    new NotComparable(
                        model.name(), 0, name, "the model of NEW does not name this output")));
    return missing;
  }

  private static Optional<String> problem(Activity base, TestModel model) {
    return base.verify(model).stream()
        .filter(d -> d.severity() == Severity.ERROR)
        .findFirst()
        .map(BaseModel::text);
  }

  private static String text(Diagnostic diagnostic) {
    return diagnostic.element().isEmpty()
        ? diagnostic.message()
        : diagnostic.element() + ": " + diagnostic.message();
  }
}
