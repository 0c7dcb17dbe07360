package org.sitaf.agent.toolchain.coverage;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import com.google.gson.JsonParseException;
import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.spool.LeftFiles;
import org.sitaf.core.verdict.Coverage;

/** Reads gcov's report of an instrumented program. */
public final class GcovReport {
  private static final Duration UNIT_TIMEOUT = Duration.ofMinutes(1);
  private static final Duration TOTAL_TIMEOUT = Duration.ofMinutes(5);
  private static final int MAX_FILES = 10_000;
  private static final int MAX_BYTES = 32 << 20;
  private static final String DATA = ".gcda";
  private static final String NOTES = ".gcno";

  private GcovReport() {}

  /**
   * Reads the recorded data. gcov runs in the sandbox, because its input comes from untrusted
   * processes.
   *
   * @param data holds one folder per process, with {@code *.gcda} files at any depth
   * @param notes the {@code *.gcno} files of the compilation, with the same names
   * @param scratch absolute folder for temporary files
   * @param activity prefix of the activity's paths in the report, such as {@code activity/}
   * @param sources folder of the component's sources in the activity; other files are ignored
   */
  public static Coverage read(
      Path data, Path notes, Path scratch, Sandbox sandbox, String activity, String sources)
      throws IOException, InterruptedException {
    LineCounts counts = new LineCounts();
    Map<String, Path> units = new HashMap<>();
    for (Path note : LeftFiles.in(notes, file -> file.toString().endsWith(NOTES), MAX_FILES)) {
      units.put(note.getFileName().toString().replace(NOTES, ""), note);
    }
    List<Path> recorded = LeftFiles.in(data, file -> file.toString().endsWith(DATA), MAX_FILES);
    long deadline = System.nanoTime() + TOTAL_TIMEOUT.toNanos();
    for (Path file : recorded) {
      String unit = file.getFileName().toString().replace(DATA, "");
      Path note = units.get(unit);
      if (note == null) {
        continue;
      }
      if (System.nanoTime() - deadline > 0) {
        throw new IOException(
            "gcov did not finish within " + TOTAL_TIMEOUT.toMinutes() + " minutes");
      }
      Path work = Files.createTempDirectory(Files.createDirectories(scratch), "gcov");
      Files.write(work.resolve(unit + DATA), LeftFiles.read(file, MAX_BYTES));
      Files.write(work.resolve(unit + NOTES), LeftFiles.read(note, MAX_BYTES));
      ToolResult end =
          sandbox.run(
              Confinement.of(
                  List.of("gcov", "-j", "-t", "-b", unit + DATA), work, work, ProcessLimits.TOOL),
              UNIT_TIMEOUT);
      if (end.code() != 0) {
        throw new IOException("gcov: " + end.errors().lines().findFirst().orElse("no output"));
      }
      addTo(counts, end.output(), activity, sources);
    }
    return counts.coverage();
  }

  /** Adds the output of {@code gcov --json-format} for one unit. */
  static void addTo(LineCounts counts, String json, String activity, String sources)
      throws IOException {
    try {
      for (JsonElement element :
          JsonParser.parseString(json).getAsJsonObject().getAsJsonArray("files")) {
        JsonObject file = element.getAsJsonObject();
        String path = ofComponent(file.get("file").getAsString(), activity, sources);
        if (!path.isEmpty()) {
          file.getAsJsonArray("lines")
              .forEach(line -> addLine(counts, path, line.getAsJsonObject()));
        }
      }
    } catch (JsonParseException
        | IllegalStateException
        | UnsupportedOperationException
        | NumberFormatException
        | NullPointerException e) {
      throw new IOException("gcov's output cannot be read: " + e.getMessage(), e);
    }
  }

  private static void addLine(LineCounts counts, String path, JsonObject line) {
    int number = line.get("line_number").getAsInt();
    counts.line(path, number, line.get("count").getAsLong() > 0);
    int index = 0;
    for (JsonElement element : line.getAsJsonArray("branches")) {
      JsonObject branch = element.getAsJsonObject();
      // Exception branches are ignored: a test case cannot be expected to cover them.
      if (!branch.get("throw").getAsBoolean()) {
        counts.branch(path, number, Integer.toString(index), branch.get("count").getAsLong() > 0);
      }
      index++;
    }
  }

  /** The path in the activity; empty if it is not a source of the component. */
  private static String ofComponent(String source, String activity, String sources) {
    String path = source.startsWith("./") ? source.substring(2) : source;
    if (!path.startsWith(activity)) {
      return "";
    }
    String inside = path.substring(activity.length());
    return inside.startsWith(sources) ? inside : "";
  }
}
