package org.sitaf.agent.toolchain.java.confined;

import java.io.IOException;
import java.io.OutputStream;
import java.util.List;

/**
 * Compiles a sample source with typical features of drivers and components, so that javac has
 * loaded its classes and read the runtime before the first request.
 */
final class WarmUp {
  private static final int ROUNDS = 3;

  private static final String SOURCE =
      """
      package warmup;

      import java.util.ArrayList;
      import java.util.HashMap;
      import java.util.List;
      import java.util.Map;
      import java.util.function.Supplier;

      public final class Driver implements Supplier<String> {
        enum Kind { A, B }
        record Pair<T>(String name, T value) {}
        interface Shape { default double area() { return 0; } }
        private static final String TEXT = "a" + 1;
        private final Map<String, List<Integer>> values = new HashMap<>();
        private int count;

        @Override
        public String get() {
          StringBuilder text = new StringBuilder();
          for (Map.Entry<String, List<Integer>> entry : values.entrySet()) {
            for (int i = 0; i < entry.getValue().size(); i++) {
              text.append(entry.getKey()).append(i % 2 == 0 ? ", " : "; ");
            }
          }
          values.computeIfAbsent(TEXT, key -> new ArrayList<>()).add(count++);
          values.values().stream().flatMap(List::stream).mapToInt(i -> i * 2).sum();
          try (AutoCloseable closing = () -> {}) {
            Pair<double[]> pair = new Pair<>("x", new double[] {1.5, 2e3});
            if (!(closing instanceof Shape shape) || shape.area() > pair.value()[0]) {
              throw new IllegalStateException(String.valueOf(pair));
            }
          } catch (Exception e) {
            text.append(e.getMessage());
          }
          switch (Kind.valueOf("A")) {
            case A -> text.append('A');
            default -> throw new IllegalArgumentException();
          }
          while (count > 0 && text.length() < 10) {
            count -= 1;
          }
          return text.toString();
        }
      }
      """;

  private WarmUp() {}

  static void run(JavaCompilation compilation) throws IOException {
    // Stops as soon as a request arrives.
    for (int i = 0; i < ROUNDS && System.in.available() == 0; i++) {
      compilation.run(
          new CompileRequest(
              List.of(new MemorySource(0, "warmup/Driver.java", SOURCE)),
              List.of(),
              "warmup.Driver",
              ""),
          OutputStream.nullOutputStream());
    }
  }
}
