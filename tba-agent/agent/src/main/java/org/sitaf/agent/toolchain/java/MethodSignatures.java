package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.sitaf.agent.toolchain.debug.DebugOrder;

/**
 * Finds the methods under test in the compiled classes, with the class that declares them and the
 * types of their parameters: a debugger finds neither inherited nor overloaded methods by name.
 */
final class MethodSignatures {
  private static final Pattern TYPE =
      Pattern.compile("(?:class|interface) ([\\w.$]+)(?:<.*>)?(?: extends ([\\w.$]+))?.*");
  private static final Pattern METHOD = Pattern.compile("  [^(]*?([\\w$]+)\\(.*\\).*;");
  private static final Pattern DESCRIPTOR = Pattern.compile("    descriptor: \\((.*)\\).*");
  private static final Pattern PARAMETER = Pattern.compile("(\\[*)(?:L([^;]+);|(.))");
  private static final Pattern FLAGS = Pattern.compile("    flags: \\(.*\\).*");

  /** Methods without code, and those that only call the one of the source. */
  private static final List<String> WITHOUT_CODE = List.of("ACC_ABSTRACT", "ACC_BRIDGE");

  private static final String KINDS = "ZBCSIJFD";
  private static final List<String> PRIMITIVES =
      List.of("boolean", "byte", "char", "short", "int", "long", "float", "double");

  private MethodSignatures() {}

  /**
   * The methods in the syntax of jdb, such as {@code robot.Arm.move(int,java.lang.String)}; with
   * the plain names if the classes cannot be read.
   */
  static List<String> of(DebugOrder order, List<Path> classPath)
      throws IOException, InterruptedException {
    List<String> found = new ArrayList<>();
    String type = order.className();
    while (!type.isEmpty() && !type.equals("java.lang.Object")) {
      String text = disassembled(type, classPath);
      found.addAll(in(text, order.methods()));
      type = superclass(text);
    }
    return found.isEmpty()
        ? order.methods().stream().map(m -> order.className() + "." + m).toList()
        : found;
  }

  /** The methods of these names in the output of javap for one class. */
  static List<String> in(String disassembled, List<String> names) {
    List<String> found = new ArrayList<>();
    String type = "";
    String method = "";
    String parameters = "";
    for (String line : disassembled.lines().toList()) {
      Matcher declared = TYPE.matcher(line);
      Matcher named = METHOD.matcher(line);
      Matcher described = DESCRIPTOR.matcher(line);
      if (described.matches()) {
        parameters = described.group(1);
      } else if (FLAGS.matcher(line).matches()) {
        if (names.contains(method) && WITHOUT_CODE.stream().noneMatch(line::contains)) {
          found.add(type + "." + method + "(" + types(parameters) + ")");
        }
        method = "";
      } else if (named.matches()) {
        method = named.group(1);
      } else if (type.isEmpty() && !line.startsWith(" ") && declared.find()) {
        type = declared.group(1);
      }
    }
    return found;
  }

  /** The superclass in the output of javap; empty if none is named. */
  static String superclass(String disassembled) {
    for (String line : disassembled.lines().toList()) {
      Matcher declared = TYPE.matcher(line);
      if (!line.startsWith(" ") && declared.find()) {
        return declared.group(2) == null ? "" : declared.group(2);
      }
    }
    return "";
  }

  private static String types(String descriptor) {
    List<String> types = new ArrayList<>();
    Matcher parameter = PARAMETER.matcher(descriptor);
    while (parameter.find()) {
      String name =
          parameter.group(2) != null
              ? parameter.group(2).replace('/', '.')
              : PRIMITIVES.get(KINDS.indexOf(parameter.group(3)));
      types.add(name + "[]".repeat(parameter.group(1).length()));
    }
    return String.join(",", types);
  }

  private static String disassembled(String type, List<Path> classPath)
      throws IOException, InterruptedException {
    String path =
        classPath.stream().map(Path::toString).collect(Collectors.joining(File.pathSeparator));
    Process javap =
        new ProcessBuilder(
                CompilerSetup.JAVA_HOME.resolve("bin").resolve("javap").toString(),
                "-v",
                "-p",
                "-cp",
                path,
                type)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    javap.getOutputStream().close();
    String output = new String(javap.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    return javap.waitFor() == 0 ? output : "";
  }
}
