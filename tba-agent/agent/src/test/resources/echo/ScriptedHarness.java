package sitaf.harness.echo;

import java.io.FileOutputStream;
import java.io.OutputStream;
import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Keeps the contract of a test application with its executor, and nothing more. */
public class ScriptedHarness {
  private static final Pattern CASE =
      Pattern.compile("<case no=\"(\\d+)\".*?<value>(-?\\d+)</value>", Pattern.DOTALL);

  public static void main(String[] arguments) throws Exception {
    Map<String, String> options = new HashMap<>();
    for (int i = 0; i < arguments.length; i += 2) {
      options.put(arguments[i], arguments[i + 1]);
    }
    int from = Integer.parseInt(options.get("--from"));
    String suite = Files.readString(Path.of(options.get("--suite")));
    Method takeLine = Class.forName("org.sitaf.runtime.EarlyStart").getDeclaredMethod("takeLine");
    takeLine.setAccessible(true);
    String token = takeLine.invoke(null) + " ";
    int number = 0;
    String descriptor = options.get("--results").replace("fd:", "/dev/fd/");
    try (OutputStream results = new FileOutputStream(descriptor)) {
      demo.Component component = new demo.Component();
      results.write((++number + " " + token + "\n").getBytes(StandardCharsets.UTF_8));
      Matcher each = CASE.matcher(suite);
      while (each.find()) {
        int no = Integer.parseInt(each.group(1));
        if (no >= from) {
          int value = Integer.parseInt(each.group(2));
          String line;
          try {
            int actual = component.echo(value);
            line = "outcome=\"RETURNED\"><actual name=\"return\">" + actual + "</actual><processing_time unit=\"us\" "
                + "hardware=\"0\" stub=\"0\">1.5</processing_time></case_record>\n";
          } catch (IllegalStateException e) {
            System.err.println("sitaf: " + e.getMessage());
            System.exit(3);
            return;
          } catch (Exception e) {
            line = "outcome=\"THREW\"><thrown>" + e.getClass().getSimpleName() + "</thrown><message>" + e.getMessage()
                + "</message></case_record>\n";
          }
          line = ++number + " " + token + "<case_record no=\"" + no + "\" " + line;
          results.write(line.getBytes(StandardCharsets.UTF_8));
        }
      }
    }
    System.exit(0);
  }
}
