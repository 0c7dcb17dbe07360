import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/** Copies of examples whose models have other oracles. */
final class Variants {
  private static final String INPUTS_END = "</input_spec_list>";

  private Variants() {}

  /** Copies an example, and replaces a part of its model; {@code pattern} must match. */
  static Path of(Path example, Path folder, String model, String pattern, String replacement)
      throws IOException {
    try (Stream<Path> files = Files.walk(example)) {
      for (Path file : files.toList()) {
        Path copy = folder.resolve(example.relativize(file).toString());
        if (Files.isDirectory(file)) {
          Files.createDirectories(copy);
        } else {
          Files.copy(file, copy);
        }
      }
    }
    Path file = folder.resolve(model);
    String text = Files.readString(file);
    String changed = text.replaceFirst("(?s)" + pattern, replacement);
    if (changed.equals(text)) {
      throw new IllegalStateException(file + ": nothing matches " + pattern);
    }
    Files.writeString(file, changed);
    return folder;
  }

  /** A list of conditions of the model. */
  static String conditions(String kind, List<String> formulas) {
    return formulas.stream()
        .map(
            formula ->
                "<%1$s name='condition %2$d'>%3$s</%1$s>"
                    .formatted(
                        kind,
                        formulas.indexOf(formula) + 1,
                        formula.replace("&", "&amp;").replace("<", "&lt;")))
        .collect(Collectors.joining("", "<" + kind + "_spec_list>", "</" + kind + "_spec_list>"));
  }

  /** A model with this number of elements, each with a boundary value analysis, and a condition. */
  static String largeModel(int elements) {
    StringBuilder text =
        new StringBuilder(
            "<test_model><name>Large</name><target interface='Service' method='Call'/><input_spec_list>");
    for (int i = 0; i < elements; i++) {
      text.append(
          """
          <test_element abstract_type="NUMERIC" real_type="double"><name>x%d</name><type>TDI</type>
            <test_spec type="BVA" offset="0.5">
              <equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="0" max="10"/>
            </test_spec>
          </test_element>
          """
              .formatted(i));
    }
    text.append(INPUTS_END).append("<post_condition_spec_list>");
    for (int i = 0; i < elements; i++) {
      text.append(
          "<post_condition name='c%1$d'>abs(x%1$d - 5.0) * 2.0 + sqrt(x%1$d) &lt; 100.0 || !valid_x%1$d</post_condition>"
              .formatted(i));
    }
    return text.append("</post_condition_spec_list><order_of_combinations>2</order_of_combinations></test_model>").toString();
  }
}
