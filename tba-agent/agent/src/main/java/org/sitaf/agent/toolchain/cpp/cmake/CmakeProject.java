package org.sitaf.agent.toolchain.cpp.cmake;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.core.activity.ActivityProfile.Component;
import org.sitaf.core.activity.CmakeTarget;

/**
 * The CMake project of a component. CMake, make and the compiler run in the sandbox, without
 * network. The project stays the top-level project; a file that CMake includes after each {@code
 * project()} adds a program that uses the component's target, and CMake's file API reports what
 * such a program is compiled and linked with.
 */
public final class CmakeProject {
  /** {@code cmake_language(DEFER)}. */
  private static final int[] OLDEST = {3, 19};

  private static final String PROBE = "probe.cmake";
  private static final Duration VERSION_TIMEOUT = Duration.ofSeconds(20);
  private static final Pattern VERSION = Pattern.compile("cmake version (\\d+)\\.(\\d+)[^\\s]*");
  private static final int PARALLEL = 2;
  private static final int MESSAGE_LINES = 12;
  private static final Pattern ERROR =
      Pattern.compile(
          "CMake Error(?: at (?<file>[^\\n]+?):(?<line>\\d+))?[^\\n]*\\n(?<text>.*)",
          Pattern.DOTALL);

  private final Compilation compilation;
  private final Path compiler;
  private final List<String> cppFlags;
  private final List<String> cFlags;
  private final CmakeTarget target;
  private final Path source;
  private final Path folder;
  private final Path tools;

  /**
   * @param compiler the C++ compiler
   * @param cppFlags options for C++ sources of the project
   * @param cFlags options for C sources, which CMake's default compiler compiles
   */
  public CmakeProject(
      Compilation compilation, Path compiler, List<String> cppFlags, List<String> cFlags) {
    Component component = compilation.application().activity().profile().component();
    this.compilation = compilation;
    this.compiler = compiler;
    this.cppFlags = List.copyOf(cppFlags);
    this.cFlags = List.copyOf(cFlags);
    this.target = Objects.requireNonNull(component.cpp().cmake());
    this.source = compilation.activity().resolve(Objects.requireNonNull(component.sources()));
    this.folder = compilation.scratch().resolve("cmake");
    this.tools = compilation.scratch().resolve("cmake-tools");
  }

  /** A failed step. */
  public static final class BuildFailedException extends Exception {
    private static final long serialVersionUID = 1;

    private final String errors;

    BuildFailedException(String message, String errors) {
      super(message);
      this.errors = errors;
    }

    /** What the compilers printed. */
    public String errors() {
      return errors;
    }
  }

  /**
   * Configures the project and builds the target.
   *
   * @throws CompilationException if CMake is missing or rejects the project
   * @throws BuildFailedException if the target does not compile
   */
  public LinkedTarget build()
      throws CompilationException, BuildFailedException, IOException, InterruptedException {
    requireCmake();
    Files.createDirectories(folder);
    Files.createDirectories(tools);
    FileApi.request(folder);
    try (InputStream probe = CmakeProject.class.getResourceAsStream(PROBE)) {
      Files.write(tools.resolve(PROBE), Objects.requireNonNull(probe).readAllBytes());
    }
    long startMillis = System.currentTimeMillis();
    ToolResult configured = run(configuration());
    if (configured.code() != 0) {
      throw new CompilationException(
          "cmake does not configure the project: " + problem(configured), List.of());
    }
    ToolResult built =
        run(
            List.of(
                "cmake",
                "--build",
                folder.toString(),
                "--target",
                "sitaf_probe",
                "--parallel",
                Integer.toString(PARALLEL)));
    if (built.code() != 0) {
      throw new BuildFailedException(
          built.timedOut()
              ? "the build of "
                  + target.name()
                  + " did not finish within "
                  + compilation.atMost().toSeconds()
                  + " s"
              : "the target " + target.name() + " does not compile",
          built.errors());
    }
    return new FileApi(folder, compilation.sources(), tools).target(startMillis, built.errors());
  }

  private List<String> configuration() {
    List<String> command =
        new ArrayList<>(
            List.of(
                "cmake",
                "-S",
                source.toString(),
                "-B",
                folder.toString(),
                "-G",
                "Unix Makefiles",
                "-Wno-dev"));
    Map<String, String> variables = new TreeMap<>();
    variables.put("CMAKE_BUILD_TYPE", "RelWithDebInfo");
    // As for sources that SITAF compiles; NDEBUG would switch assertions off.
    String optimization = compilation.debugging() ? "-O0 -g" : "-O1 -g1";
    variables.put("CMAKE_CXX_FLAGS_RELWITHDEBINFO", optimization);
    variables.put("CMAKE_C_FLAGS_RELWITHDEBINFO", optimization);
    variables.put("BUILD_SHARED_LIBS", "OFF");
    variables.put("BUILD_TESTING", "OFF");
    variables.putAll(target.options());
    variables.put("CMAKE_CXX_COMPILER", compiler.toString());
    variables.put("CMAKE_CXX_FLAGS", String.join(" ", cppFlags));
    variables.put("CMAKE_C_FLAGS", String.join(" ", cFlags));
    variables.put("CMAKE_POSITION_INDEPENDENT_CODE", "ON");
    variables.put("CMAKE_PROJECT_INCLUDE", tools.resolve(PROBE).toString());
    variables.put("FETCHCONTENT_FULLY_DISCONNECTED", "ON");
    variables.put("SITAF_TARGET", target.name());
    variables.forEach((name, value) -> command.add("-D" + name + "=" + value));
    return command;
  }

  private ToolResult run(List<String> command) throws IOException, InterruptedException {
    Path temporary = Files.createTempDirectory(compilation.scratch(), "tool");
    return compilation
        .sandbox()
        .run(
            Confinement.of(command, folder, temporary, ProcessLimits.TOOL)
                .withEnvironment(Map.of("CXX", compiler.toString(), "LC_ALL", "C.UTF-8"))
                .reading(List.of(compilation.sources(), tools)),
            compilation.atMost());
  }

  /** The first error of CMake with its place; without one, the end of what it printed. */
  private String problem(ToolResult end) {
    if (end.timedOut()) {
      return "it did not finish within " + compilation.atMost().toSeconds() + " s";
    }
    List<String> lines = end.errors().lines().toList();
    for (int i = 0; i < lines.size(); i++) {
      if (lines.get(i).startsWith("CMake Error")) {
        List<String> block = lines.subList(i, Math.min(lines.size(), i + MESSAGE_LINES));
        Matcher error = ERROR.matcher(String.join("\n", block));
        if (error.find()) {
          return place(error.group("file"), error.group("line"))
              + firstParagraph(error.group("text"));
        }
      }
    }
    return lines.isEmpty() ? "exit code " + end.code() : lines.get(lines.size() - 1);
  }

  private String place(String file, String line) {
    return file == null || file.startsWith(tools.toString())
        ? ""
        : file.replace(source + "/", "") + ":" + line + ": ";
  }

  /** Lines up to a blank one that follows text, joined. */
  private static String firstParagraph(String text) {
    StringBuilder found = new StringBuilder();
    for (String line : text.lines().toList()) {
      if (line.isBlank() || line.startsWith("Call Stack")) {
        if (!found.isEmpty()) {
          break;
        }
        continue;
      }
      found.append(found.isEmpty() ? "" : " ").append(line.strip());
    }
    return found.toString().replaceFirst("^SITAF: ", "");
  }

  private void requireCmake() throws CompilationException, IOException, InterruptedException {
    Optional<String> printed = version();
    Matcher version = VERSION.matcher(printed.orElse(""));
    if (!version.find()) {
      throw new CompilationException(
          "the component needs cmake and make, which are not installed; install them with: apt-get"
              + " install cmake make",
          List.of());
    }
    int major = Integer.parseInt(version.group(1));
    int minor = Integer.parseInt(version.group(2));
    if (major < OLDEST[0] || major == OLDEST[0] && minor < OLDEST[1]) {
      throw new CompilationException(
          "cmake %d.%d is too old; %d.%d is the oldest version that works"
              .formatted(major, minor, OLDEST[0], OLDEST[1]),
          List.of());
    }
  }

  private Optional<String> version() throws IOException, InterruptedException {
    Path working = Files.createTempDirectory(compilation.scratch(), "tool");
    try {
      ToolResult end =
          compilation
              .sandbox()
              .run(
                  Confinement.of(
                      List.of("sh", "-c", "make --version >/dev/null && cmake --version"),
                      working,
                      working,
                      ProcessLimits.TOOL),
                  VERSION_TIMEOUT);
      return end.code() == 0 ? Optional.of(end.output()) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    }
  }
}
