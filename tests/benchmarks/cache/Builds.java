import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.sitaf.agent.compiler.TestApplicationCompiler;
import org.sitaf.agent.sandbox.Sandbox;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.CompiledApplication;
import org.sitaf.agent.toolchain.Toolchain;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import org.sitaf.core.activity.ActivityProfile;
import org.sitaf.core.activity.ActivityProfile.Language;
import org.sitaf.core.activity.FileTree;
import org.sitaf.core.harness.TestApplication;

/** Compiles like an agent, with its own caches. */
final class Builds {
  private final Path folder;
  private final Toolchains toolchains;
  private final Sandbox sandbox;

  /**
   * Builds below a folder.
   *
   * @param runtimes the compiled runtime of C++, which no edit touches
   */
  Builds(Path folder, Path installation, Path runtimes, Sandbox sandbox) throws IOException {
    this.folder = folder;
    this.sandbox = sandbox;
    this.toolchains = new Toolchains(new ToolchainPlaces(installation, cache()));
    Files.createDirectories(cache().resolve("cpp"));
    Files.createSymbolicLink(cache().resolve("cpp/runtime"), Files.createDirectories(runtimes));
  }

  private Path cache() {
    return folder.resolve("cache");
  }

  /**
   * The result of a build.
   *
   * @param files compiled files by path; a single entry if the compiler reported errors
   * @param asked whether the toolchain was called
   * @param units translation units that were compiled
   */
  record Built(Map<String, byte[]> files, boolean asked, Set<String> units) {}

  /** A toolchain that records its calls. */
  private static final class Watched implements Toolchain {
    private final Toolchain toolchain;
    private boolean asked;

    Watched(Toolchain toolchain) {
      this.toolchain = toolchain;
    }

    @Override
    public Language language() {
      return toolchain.language();
    }

    @Override
    public String version() {
      return toolchain.version();
    }

    @Override
    public String identity() throws IOException, InterruptedException {
      return toolchain.identity();
    }

    @Override
    public boolean readsElsewhere(String path, ActivityProfile profile) {
      return toolchain.readsElsewhere(path, profile);
    }

    @Override
    public boolean isCurrent(Compilation compilation, Path compiled) throws IOException {
      return toolchain.isCurrent(compilation, compiled);
    }

    @Override
    public void compile(Compilation compilation)
        throws CompilationException, InterruptedException, IOException {
      asked = true;
      toolchain.compile(compilation);
    }

    @Override
    public CompiledApplication open(Compilation compilation)
        throws CompilationException, InterruptedException, IOException {
      return toolchain.open(compilation);
    }
  }

  Built build(Project project) throws Exception {
    TestApplication application = project.application();
    Path build = Files.createTempDirectory(folder, "build");
    Path sources = build.resolve("application");
    FileTree files = application.files();
    for (String path : files.paths()) {
      Path file = sources.resolve(path);
      Files.createDirectories(file.getParent());
      Files.write(file, files.content(path).orElseThrow());
    }
    Language language = project.java ? Language.JAVA : Language.CPP;
    Watched toolchain =
        new Watched(
            toolchains
                .of(language)
                .orElseThrow(() -> new IllegalStateException(toolchains.missingMessage(language))));
    TestApplicationCompiler compiler =
        new TestApplicationCompiler(toolchain, toolchains.compiled(), false, sandbox);
    Compilation compilation = compiler.begin(application, sources, build);
    Map<String, byte[]> brought = new TreeMap<>();
    try {
      compiler.compile(compilation);
      brought.putAll(contents(compilation.output()));
      // Inputs of this machine are not part of the result.
      brought.remove("inputs");
    } catch (CompilationException e) {
      brought.put("rejected", String.valueOf(e.getMessage()).getBytes());
    }
    Set<String> units = units(compilation.scratch(), sources);
    delete(build);
    return new Built(brought, toolchain.asked, units);
  }

  /** The inputs according to the dependency files of the compilers. */
  private static Set<String> units(Path scratch, Path sources) throws IOException {
    Set<String> units = new TreeSet<>();
    try (Stream<Path> all = Files.walk(scratch)) {
      for (Path file : all.filter(f -> f.toString().matches(".*/unit\\d+\\.d")).toList()) {
        // The line may be broken before the first name.
        String[] words = Files.readString(file).split("[\\s\\\\]+", 3);
        units.add(words[1].substring(sources.toString().length() + 1));
      }
    }
    return units;
  }

  private static Map<String, byte[]> contents(Path folder) throws IOException {
    Map<String, byte[]> contents = new TreeMap<>();
    try (Stream<Path> all = Files.walk(folder)) {
      for (Path file : all.filter(Files::isRegularFile).toList()) {
        contents.put(folder.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
    return contents;
  }

  /** Deletes all compiled objects except the runtime. */
  void forget() throws IOException {
    delete(cache().resolve("cpp/objects"));
    delete(toolchains.compiled());
  }

  static void delete(Path folder) throws IOException {
    if (Files.exists(folder)) {
      try (Stream<Path> all = Files.walk(folder)) {
        for (Path file : all.sorted(Comparator.reverseOrder()).toList()) {
          Files.delete(file);
        }
      }
    }
  }
}
