package org.sitaf.core.model.document;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.jspecify.annotations.Nullable;
import org.sitaf.schemas.TestSpecType;

/** Finds settings of a {@code test_spec} that have no effect in its type. */
final class SettingsInUse {
  private static final Map<String, Set<String>> USED =
      Map.of(
          "ECP", Set.of("equiv_class", "representatives", "offset", "special"),
          "BVA", Set.of("equiv_class", "offset", "special"),
          "RANDOM",
              Set.of(
                  "count",
                  "min",
                  "max",
                  "distribution",
                  "mean",
                  "standard_deviation",
                  "range",
                  "special"),
          "RANDOM_STRING",
              Set.of(
                  "min_length",
                  "max_length",
                  "alphabet",
                  "number",
                  "special_char",
                  "space",
                  "negative_char_list"),
          "ROTATION", Set.of("as", "count"),
          "DIRECTION", Set.of("count", "length"),
          "POSE", Set.of("as", "count", "min", "max"),
          "RELATED", Set.of("to", "offsets"));

  private SettingsInUse() {}

  /** One message for each setting that has no effect. */
  static List<String> check(TestSpecType spec) {
    Set<String> used = USED.get(String.valueOf(spec.getType()));
    if (used == null) {
      return List.of();
    }
    List<String> messages = new ArrayList<>();
    given(spec)
        .forEach(
            (name, value) -> {
              if (value != null && !used.contains(name)) {
                messages.add(
                    name
                        + " has no effect in "
                        + spec.getType()
                        + ", which uses "
                        + String.join(", ", new TreeSet<>(used))
                        + "; remove it");
              }
            });
    if (used.contains("distribution")) {
      distribution(spec, messages);
    }
    return messages;
  }

  private static void distribution(TestSpecType spec, List<String> messages) {
    var element = spec.getDistributionElement();
    String name = spec.getDistribution();
    if (element != null) {
      // Its own text, ranges and attributes are read together with it.
      return;
    }
    boolean hasRanges = !spec.getRange().isEmpty();
    String kind = name == null ? (hasRanges ? "weighted" : "uniform") : name.strip();
    boolean hasMoments =
        spec.getMean() != null
            || spec.getMeanElement() != null
            || spec.getStandardDeviation() != null
            || spec.getStandardDeviationElement() != null;
    if (hasMoments && !kind.equals("normal")) {
      messages.add(
          "mean and standard_deviation have no effect in the distribution "
              + kind
              + "; use distribution=\"normal\" or remove them");
    }
    if (hasRanges && !kind.equals("weighted")) {
      messages.add(
          "range has no effect in the distribution "
              + kind
              + "; use distribution=\"weighted\" or remove it");
    }
  }

  private static Map<String, @Nullable Object> given(TestSpecType spec) {
    Map<String, @Nullable Object> given = new LinkedHashMap<>();
    given.put("equiv_class", spec.getEquivClass().isEmpty() ? null : spec.getEquivClass());
    given.put("range", spec.getRange().isEmpty() ? null : spec.getRange());
    given.put("offset", either(spec.getOffset(), spec.getOffsetElement()));
    given.put("special", spec.getSpecial());
    given.put(
        "representatives", either(spec.getRepresentatives(), spec.getRepresentativesElement()));
    given.put("count", either(spec.getCount(), spec.getCountElement()));
    given.put("min", either(spec.getMin(), spec.getMinElement()));
    given.put("max", either(spec.getMax(), spec.getMaxElement()));
    given.put("distribution", either(spec.getDistribution(), spec.getDistributionElement()));
    given.put("mean", either(spec.getMean(), spec.getMeanElement()));
    given.put(
        "standard_deviation",
        either(spec.getStandardDeviation(), spec.getStandardDeviationElement()));
    given.put("as", spec.getAs());
    given.put("length", spec.getLength());
    given.put("to", spec.getTo());
    given.put("offsets", spec.getOffsets());
    given.put("min_length", either(spec.getMinLength(), spec.getMinLengthElement()));
    given.put("max_length", either(spec.getMaxLength(), spec.getMaxLengthElement()));
    given.put("alphabet", either(spec.getAlphabet(), spec.getAlphabetElement()));
    given.put("number", either(spec.getNumber(), spec.getNumberElement()));
    given.put("special_char", either(spec.getSpecialChar(), spec.getSpecialCharElement()));
    given.put("space", either(spec.getSpace(), spec.getSpaceElement()));
    given.put(
        "negative_char_list",
        either(spec.getNegativeCharList(), spec.getNegativeCharListElement()));
    return given;
  }

  private static @Nullable Object either(@Nullable Object attribute, @Nullable Object element) {
    return attribute != null ? attribute : element;
  }
}
