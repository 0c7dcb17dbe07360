package org.sitaf.cli.compare;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.zip.Deflater;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.trajectory.Trace;

/** The signals of the cases of one run, in compressed files: those of all cases fill the memory. */
public record SignalFiles(Path folder) {
  private static final int BUFFER = 1 << 16;

  void write(int no, Trace trace) {
    Deflater fast = new Deflater(Deflater.BEST_SPEED);
    try (DataOutputStream out =
        new DataOutputStream(
            new BufferedOutputStream(
                new DeflaterOutputStream(Files.newOutputStream(file(no)), fast, BUFFER), BUFFER))) {
      out.writeLong(trace.firstNanos());
      out.writeLong(trace.stepNanos());
      out.writeInt(trace.count());
      out.writeInt(trace.names().size());
      for (int i = 0; i < trace.names().size(); i++) {
        out.writeUTF(trace.names().get(i));
        for (double number : trace.columns().get(i)) {
          out.writeDouble(number);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException("cannot write the signals of case " + no, e);
    } finally {
      fast.end();
    }
  }

  /** The signals of a case; null if there are none. */
  @Nullable Trace read(int no) {
    if (!Files.exists(file(no))) {
      return null;
    }
    try (DataInputStream in =
        new DataInputStream(
            new BufferedInputStream(
                new InflaterInputStream(Files.newInputStream(file(no))), BUFFER))) {
      long first = in.readLong();
      long step = in.readLong();
      int count = in.readInt();
      int signals = in.readInt();
      List<String> names = new ArrayList<>();
      List<double[]> columns = new ArrayList<>();
      for (int i = 0; i < signals; i++) {
        names.add(in.readUTF());
        double[] column = new double[count];
        for (int k = 0; k < count; k++) {
          column[k] = in.readDouble();
        }
        columns.add(column);
      }
      return new Trace(first, step, names, columns);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read the signals of case " + no, e);
    }
  }

  private Path file(int no) {
    return folder.resolve(no + ".signals");
  }
}
