import java.util.LinkedHashMap;
import java.util.Map;

/** Specifications of the infrared sensor: the one of the example, and weaker ones. */
final class Specifications {
  private static final String EXPECTED = "(?s)<expected>.*?</expected>";
  private static final String TOLERANCE = "<tolerance absolute=\"1e-9\" relative=\"0\"/>";

  private Specifications() {}

  /** The models by what is weak about them. */
  static Map<String, String> of(String model) {
    Map<String, String> all = new LinkedHashMap<>();
    all.put("the example", model);
    all.put("tolerance 0.6", tolerance(model, "0.6"));
    all.put("tolerance 2", tolerance(model, "2"));
    all.put("tolerance 12, wider than the range", tolerance(model, "12"));
    all.put("one middle value of each input", values(model, "4", "4", "5.0"));
    all.put("three valid values of each input", values(model, "2 4 6", "2 4 6", "2.0 5.0 8.0"));
    all.put(
        "invalid values not judged",
        expected(model, "!valid ? \"!any\" : IndexOfSensor &lt;= NumOfSensor ? Distance : -1.0"));
    all.put(
        "only valid pairs judged",
        expected(model, "valid &amp;&amp; IndexOfSensor &lt;= NumOfSensor ? Distance : \"!any\""));
    all.put(
        "only refused pairs judged",
        expected(model, "valid &amp;&amp; IndexOfSensor &lt;= NumOfSensor ? \"!any\" : -1.0"));
    all.put("only a range is required", condition(model, "actual &gt;= -1.0 &amp;&amp; actual &lt;= 10.5"));
    all.put("only a number is required", condition(model, "!is_nan(actual)"));
    return all;
  }

  private static String replaced(String model, String pattern, String by) {
    String changed = model.replaceAll(pattern, by.replace("\\", "\\\\").replace("$", "\\$"));
    if (changed.equals(model)) {
      throw new IllegalStateException("nothing matches " + pattern);
    }
    return changed;
  }

  private static String tolerance(String model, String absolute) {
    return replaced(model, TOLERANCE, "<tolerance absolute=\"" + absolute + "\" relative=\"0\"/>");
  }

  private static String expected(String model, String expression) {
    return replaced(model, EXPECTED, "<expected>" + expression + "</expected>");
  }

  private static String condition(String model, String expression) {
    String without = replaced(replaced(model, EXPECTED, ""), TOLERANCE, "");
    return replaced(
        without,
        "</output_spec_list>",
        "</output_spec_list><post_condition_spec_list><post_condition>"
            + expression
            + "</post_condition></post_condition_spec_list>");
  }

  private static String values(String model, String index, String count, String distance) {
    String changed = model;
    for (String values : new String[] {index, count, distance}) {
      StringBuilder list = new StringBuilder("<user_value_list>");
      for (String value : values.split(" ")) {
        list.append("<value>").append(value).append("</value>");
      }
      changed = changed.replaceFirst("(?s)<test_spec .*?</test_spec>", list + "</user_value_list>");
    }
    return changed;
  }
}
