package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;

/**
 * Packages by their Maven coordinates, with all that they need at run time. Maven fetches them, in
 * the sandbox, when they are asked for first, and never while a test runs; no code of theirs runs
 * then. It reaches the repositories that this machine is configured for, and none that a package
 * names: a package may name any address.
 */
final class MavenPackages {
  private static final String PLUGIN =
      "org.apache.maven.plugins:maven-dependency-plugin:3.10.0:copy-dependencies";
  private static final String WORD = "[A-Za-z0-9_][A-Za-z0-9_.-]{0,199}";
  private static final Pattern COORDINATES =
      Pattern.compile("(" + WORD + "):(" + WORD + "):(" + WORD + ")");

  /** What Maven may put before a line even where it is told to use no colours. */
  private static final Pattern COLOUR = Pattern.compile("\u001b\\[[0-9;]*m");

  /** How many lines of Maven's complaint are told. */
  private static final int COMPLAINT = 6;

  private static final String REMEDY =
      "; install it (apt-get install maven), or give a .jar as 'library:'";

  /** What a shell or a sandbox ends with where there is no such program. */
  private static final int NOT_FOUND = 127;

  private static final Pattern JAR = Pattern.compile("[A-Za-z0-9_.+-]{1,250}\\.jar");
  private static final int MOST_JARS = 1000;

  /** Where a repository has its name in Maven's settings. */
  private static final Pattern REPOSITORY =
      Pattern.compile("<repository>.*?<id>\\s*([A-Za-z0-9_.-]{1,100})\\s*</id>", Pattern.DOTALL);

  private final Path cache;
  private final Lock fetching = new ReentrantLock();

  MavenPackages(Path cache) {
    this.cache = cache;
  }

  /**
   * The jars of a package, fetched when they are asked for first.
   *
   * @param wanted such as {@code org.apache.commons:commons-math3:3.6.1}
   * @throws CompilationException if it is spelled otherwise or cannot be fetched
   */
  List<Path> jars(String wanted, Compilation compilation)
      throws CompilationException, IOException, InterruptedException {
    Matcher coordinates = COORDINATES.matcher(wanted.strip());
    if (!coordinates.matches()) {
      throw refused(
          "'"
              + wanted
              + "' is not a package such as org.apache.commons:commons-math3:3.6.1, with group,"
              + " artifact and version");
    }
    Path folder = cache.resolve("packages").resolve(wanted.strip().replace(':', '!'));
    // Maven's repository is not made for several that write it.
    fetching.lockInterruptibly();
    try {
      if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
        fetch(coordinates, folder, compilation);
      }
    } finally {
      fetching.unlock();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files
          .filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
          .filter(file -> JAR.matcher(file.getFileName().toString()).matches())
          .limit(MOST_JARS)
          .sorted()
          .toList();
    }
  }

  private void fetch(Matcher coordinates, Path folder, Compilation compilation)
      throws CompilationException, IOException, InterruptedException {
    Path repository = Files.createDirectories(cache.resolve("repository"));
    Path working = Files.createTempDirectory(compilation.scratch(), "maven-");
    Path jars = Files.createDirectories(working.resolve("jars"));
    Files.writeString(
        working.resolve("pom.xml"),
        """
        <project>
          <modelVersion>4.0.0</modelVersion>
          <groupId>sitaf</groupId>
          <artifactId>component</artifactId>
          <version>1</version>
          <dependencies>
            <dependency>
              <groupId>%s</groupId>
              <artifactId>%s</artifactId>
              <version>%s</version>
            </dependency>
          </dependencies>
        </project>
        """
            .formatted(coordinates.group(1), coordinates.group(2), coordinates.group(3)),
        StandardCharsets.UTF_8);
    Path settings = working.resolve("settings.xml");
    Files.writeString(settings, settings(configuration()), StandardCharsets.UTF_8);
    List<String> command =
        List.of(
            "mvn",
            "--batch-mode",
            "--quiet",
            "--strict-checksums",
            "--settings",
            settings.toString(),
            // What was not there before may be there by now.
            "--update-snapshots",
            "-Dmaven.repo.local=" + repository,
            "-DincludeScope=runtime",
            "-DoutputDirectory=" + jars,
            PLUGIN);
    ToolResult end;
    try {
      end =
          compilation
              .sandbox()
              .run(
                  Confinement.of(command, working, working, ProcessLimits.TOOL)
                      .withEnvironment(Map.of("JAVA_HOME", System.getProperty("java.home")))
                      .reading(List.of(Path.of(System.getProperty("java.home"))))
                      .reading(installation())
                      .writing(List.of(repository))
                      .withNetwork(),
                  compilation.atMost());
    } catch (IOException e) {
      throw refused(coordinates.group() + ": Maven cannot be started: " + e.getMessage() + REMEDY);
    }
    if (end.code() != 0) {
      throw refused(coordinates.group() + ": " + complaint(end, compilation));
    }
    Files.createDirectories(folder.getParent());
    try {
      Files.move(jars, folder, StandardCopyOption.ATOMIC_MOVE);
    } catch (FileSystemException e) {
      if (!Files.isDirectory(folder)) {
        throw e;
      }
      // Another agent has fetched the same meanwhile.
    }
  }

  /**
   * Settings that keep Maven from every repository but its central one and those that the
   * installation's own settings name, which stay in force.
   */
  static String settings(String installed) {
    StringBuilder open = new StringBuilder("*,!central");
    REPOSITORY
        .matcher(installed)
        .results()
        .map(found -> found.group(1))
        .distinct()
        .forEach(name -> open.append(",!").append(name));
    return """
        <settings>
          <mirrors>
            <mirror>
              <id>named-by-a-package</id>
              <mirrorOf>%s</mirrorOf>
              <url>http://0.0.0.0/</url>
              <blocked>true</blocked>
            </mirror>
          </mirrors>
        </settings>
        """
        .formatted(open);
  }

  /** The installation's settings; empty where there are none. */
  private static String configuration() throws IOException {
    StringBuilder text = new StringBuilder();
    for (Path part : installation()) {
      Path settings = part.resolve("settings.xml");
      if (Files.isRegularFile(settings)) {
        text.append(Files.readString(settings)).append('\n');
      }
    }
    return text.toString().replaceAll("(?s)<!--.*?-->", "");
  }

  /** What Maven reads of its own; its settings may lie elsewhere, and only be linked to. */
  private static List<Path> installation() throws IOException {
    List<Path> found = new ArrayList<>();
    for (String folder : System.getenv().getOrDefault("PATH", "").split(File.pathSeparator)) {
      Path program = Path.of(folder.isEmpty() ? "." : folder, "mvn");
      if (Files.isExecutable(program)) {
        Path home = program.toRealPath().getParent().getParent();
        for (Path part : List.of(home, home.resolve("conf"), home.resolve("bin/m2.conf"))) {
          if (Files.exists(part)) {
            found.add(part.toRealPath());
          }
        }
        break;
      }
    }
    return found;
  }

  private static String complaint(ToolResult end, Compilation compilation) {
    if (end.timedOut()) {
      return "Maven was given up after " + compilation.atMost().toSeconds() + " s";
    }
    if (end.code() == NOT_FOUND) {
      return "Maven is not there" + REMEDY;
    }
    List<String> errors =
        (end.output() + "\n" + end.errors())
            .lines()
            .map(line -> COLOUR.matcher(line).replaceAll(""))
            .filter(line -> line.startsWith("[ERROR]"))
            .map(line -> line.substring("[ERROR]".length()).strip())
            // Then follows how to ask Maven for more.
            .takeWhile(line -> !line.isEmpty())
            .limit(COMPLAINT)
            .toList();
    return errors.isEmpty()
        ? "Maven ended with " + end.code() + ": " + end.errors().strip()
        : String.join("; ", errors);
  }

  private static CompilationException refused(String reason) {
    return new CompilationException(
        "the component's package cannot be fetched",
        List.of(JavaToolchain.inProfile("component: package: " + reason)));
  }
}
