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
import org.sitaf.agent.sandbox.ToolEnd;
import org.sitaf.agent.spool.LeftFiles;
import org.sitaf.core.verdict.Coverage;

/** What gcov says of a program that g++ instrumented. */
public final class GcovReport {
  private static final Duration LIMIT = Duration.ofMinutes(1);
  private static final Duration LIMIT_OF_ALL = Duration.ofMinutes(5);
  private static final int MOST_FILES = 10_000;
  private static final int MOST_BYTES = 32 << 20;
  private static final String DATA = ".gcda";
  private static final String NOTES = ".gcno";

  private GcovReport() {}

  /**
   * Reads what processes have recorded; gcov, whose input they made, runs in the sandbox.
   *
   * @param data holds a folder a process, with {@code *.gcda} somewhere below
   * @param notes the {@code *.gcno} of the compilation, with the same names
   * @param scratch a folder for what nobody needs afterwards, absolute
   * @param activity how the compiler knew the folder of the activity, such as {@code activity/}
   * @param sources folder of the component's sources within the activity; others are left out
   */
  public static Coverage read(
      Path data, Path notes, Path scratch, Sandbox sandbox, String activity, String sources)
      throws IOException, InterruptedException {
    LineCounts counts = new LineCounts();
    Map<String, Path> units = new HashMap<>();
    for (Path note : LeftFiles.in(notes, file -> file.toString().endsWith(NOTES), MOST_FILES)) {
      units.put(note.getFileName().toString().replace(NOTES, ""), note);
    }
    List<Path> recorded = LeftFiles.in(data, file -> file.toString().endsWith(DATA), MOST_FILES);
    long last = System.nanoTime() + LIMIT_OF_ALL.toNanos();
    for (Path file : recorded) {
      String unit = file.getFileName().toString().replace(DATA, "");
      Path note = units.get(unit);
      if (note == null) {
        continue;
      }
      if (System.nanoTime() - last > 0) {
        throw new IOException("gcov takes longer than " + LIMIT_OF_ALL.toMinutes() + " minutes");
      }
      Path work = Files.createTempDirectory(Files.createDirectories(scratch), "gcov");
      Files.write(work.resolve(unit + DATA), LeftFiles.read(file, MOST_BYTES));
      Files.write(work.resolve(unit + NOTES), LeftFiles.read(note, MOST_BYTES));
      ToolEnd end =
          sandbox.run(
              Confinement.of(
                  List.of("gcov", "-j", "-t", "-b", unit + DATA), work, work, ProcessLimits.TOOL),
              LIMIT);
      if (end.code() != 0) {
        throw new IOException("gcov: " + end.errors().lines().findFirst().orElse("no answer"));
      }
      addTo(counts, end.output(), activity, sources);
    }
    return counts.coverage();
  }

  /** Adds what {@code gcov --json-format} prints of one unit. */
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
      throw new IOException("gcov's answer is not understood: " + e.getMessage(), e);
    }
  }

  private static void addLine(LineCounts counts, String path, JsonObject line) {
    int number = line.get("line_number").getAsInt();
    counts.line(path, number, line.get("count").getAsLong() > 0);
    int index = 0;
    for (JsonElement element : line.getAsJsonArray("branches")) {
      JsonObject branch = element.getAsJsonObject();
      // Ways that only an exception takes are nothing that a test case could be asked for.
      if (!branch.get("throw").getAsBoolean()) {
        counts.branch(path, number, Integer.toString(index), branch.get("count").getAsLong() > 0);
      }
      index++;
    }
  }

  /** The path within the activity; empty where it is no source of the component. */
  private static String ofComponent(String source, String activity, String sources) {
    String path = source.startsWith("./") ? source.substring(2) : source;
    if (!path.startsWith(activity)) {
      return "";
    }
    String inside = path.substring(activity.length());
    return inside.startsWith(sources) ? inside : "";
  }
}
