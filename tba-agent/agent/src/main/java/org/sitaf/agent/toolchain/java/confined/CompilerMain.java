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
 * Java's compiler for one request: it starts before there is one, gets warm on a source of its own,
 * reads the request from its standard input and ends with the answer.
 *
 * <p>Arguments: the runtime's jars as a class path, the path of annotation processors (or empty),
 * then the options of javac. Without a request it ends, too, which records what it loads.
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
    // Nothing else may write between the messages.
    System.setOut(System.err);
    // Sources nest deeper than the stack of a main thread reaches.
    AtomicBoolean served = new AtomicBoolean();
    Thread thread =
        new Thread(null, () -> served.set(serve(arguments, answers)), "sitaf-javac", STACK_BYTES);
    thread.start();
    thread.join();
    if (served.get()) {
      // Whatever an annotation processor has started ends, too.
      Runtime.getRuntime().halt(0);
    }
  }

  /** Serves one request; false where there was none. */
  private static boolean serve(String[] arguments, OutputStream answers) {
    List<String> options = Stream.of(arguments).skip(2).toList();
    try {
      JavaCompilation compilation =
          new JavaCompilation(path(arguments[0]), path(arguments[1]), options);
      Rehearsal.run(compilation);
      Wire.write(answers, Wire.READY, new byte[0]);
      answers.flush();
      try {
        Path folder = Path.of("").toAbsolutePath();
        compilation.run(
            CompileRequest.read(new BufferedInputStream(System.in, BUFFER), folder), answers);
      } catch (EOFException e) {
        return false;
      } catch (RuntimeException | StackOverflowError | AssertionError e) {
        // javac fails by itself on sources made for it, such as very deep expressions.
        Wire.write(answers, Wire.GAVE_UP, e.getClass().getSimpleName());
      }
      answers.flush();
    } catch (IOException e) {
      System.err.println("the compiler cannot work: " + e);
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
