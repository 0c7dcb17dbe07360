package org.sitaf.cli.run;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;
import org.sitaf.core.trajectory.TraceCsv;

/**
 * Where the signals of the cases of a model are written.
 *
 * @param folder null if they are not
 */
record SignalFolder(@Nullable Path folder) {
  /** Writes the signals of a case as {@code NO.csv}. */
  void write(int no, Trace trace) {
    if (folder != null) {
      try {
        Files.createDirectories(folder);
        Files.writeString(folder.resolve(no + ".csv"), TraceCsv.write(trace));
      } catch (IOException e) {
        throw new UncheckedIOException("cannot write the signals of case " + no, e);
      }
    }
  }
}
