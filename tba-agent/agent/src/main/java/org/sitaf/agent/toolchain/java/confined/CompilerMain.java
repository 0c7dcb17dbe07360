package org.sitaf.agent.toolchain.java.confined;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.EOFException;
import java.io.File;
import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.stream.Stream;

/**
 * Main program of the Java compiler for one request. It starts before there is a request, warms up,
 * reads the request from standard input and ends after the answer.
 *
 * <p>Arguments: the class path of the runtime, the annotation processor path (may be empty), and
 * javac options. It also ends without a request, which is used to create the class data sharing
 * archive.
 */
public final class CompilerMain {
  private static final int BUFFER = 1 << 16;
  private static final long STACK_BYTES = 16L << 20;

  private CompilerMain() {}

  /** See the class. */
  public static void main(String[] arguments) throws InterruptedException {
    @SuppressWarnings("resource")
    OutputStream answers =
        new BufferedOutputStream(new FileOutputStream(FileDescriptor.out), BUFFER);
    // Nothing else may write to standard output.
    System.setOut(System.err);
    // Sources may nest deeper than the default stack of the main thread allows.
    AtomicBoolean served = new AtomicBoolean();
    Thread thread =
        new Thread(null, () -> served.set(serve(arguments, answers)), "sitaf-javac", STACK_BYTES);
    thread.start();
    thread.join();
    if (served.get()) {
      // Also ends threads of annotation processors.
      Runtime.getRuntime().halt(0);
    }
  }

  /** Serves one request; returns false if there was none. */
  private static boolean serve(String[] arguments, OutputStream answers) {
    List<String> options = Stream.of(arguments).skip(2).toList();
    try {
      JavaCompilation compilation =
          new JavaCompilation(path(arguments[0]), path(arguments[1]), options);
      WarmUp.run(compilation);
      Wire.write(answers, Wire.READY, new byte[0]);
      answers.flush();
      try {
        Path folder = Path.of("").toAbsolutePath();
        compilation.run(
            CompileRequest.read(new BufferedInputStream(System.in, BUFFER), folder), answers);
      } catch (EOFException e) {
        return false;
      } catch (RuntimeException | StackOverflowError | AssertionError e) {
        // javac itself fails on some hostile sources, such as very deep expressions.
        Wire.write(answers, Wire.GAVE_UP, e.getClass().getSimpleName());
      }
      answers.flush();
    } catch (IOException e) {
      System.err.println("the compiler failed: " + e);
      Runtime.getRuntime().halt(2);
    }
    return true;
  }

  private static List<File> path(String text) {
    return Stream.of(text.split(File.pathSeparator))
        .filter(entry -> !entry.isEmpty())
        .map(File::new)
        .toList();
  }
}
