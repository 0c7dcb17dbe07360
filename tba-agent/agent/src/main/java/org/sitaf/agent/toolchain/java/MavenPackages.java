package org.sitaf.agent.toolchain.java;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.concurrent.locks.Lock;
import java.util.concurrent.locks.ReentrantLock;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.sandbox.Confinement;
import org.sitaf.agent.sandbox.ProcessLimits;
import org.sitaf.agent.sandbox.ToolResult;
import org.sitaf.agent.toolchain.Compilation;
import org.sitaf.agent.toolchain.CompilationException;
import org.sitaf.agent.toolchain.SourceDiagnostic;
import org.sitaf.core.activity.lock.ActivityLock;
import org.sitaf.core.activity.lock.ResolvedPackage;
import org.sitaf.core.digest.Sha256;

/**
 * Packages by Maven coordinates, with their runtime dependencies. Maven downloads them in the
 * sandbox at their first use, never during a test, and executes none of their code. It uses only
 * the repositories that this machine is configured for, because the POM of a package may name any
 * address.
 */
final class MavenPackages {
  private static final String PLUGIN =
      "org.apache.maven.plugins:maven-dependency-plugin:3.10.0:copy-dependencies";
  private static final String WORD = "[A-Za-z0-9_][A-Za-z0-9_.-]{0,199}";
  private static final Pattern COORDINATES =
      Pattern.compile("(" + WORD + "):(" + WORD + "):(" + WORD + ")");

  /** Prefix that Maven may write even without colors. */
  private static final Pattern COLOUR = Pattern.compile("\u001b\\[[0-9;]*m");

  /** Number of error lines to report. */
  private static final int MAX_ERROR_LINES = 6;

  private static final String REMEDY =
      "; install it (apt-get install maven), or give a .jar as 'library:'";

  /** Exit code of a shell or sandbox for a missing program. */
  private static final int NOT_FOUND = 127;

  /** The place of a jar in the layout of a repository. */
  private static final Pattern JAR =
      Pattern.compile(
          "((?:[A-Za-z0-9_.-]{1,100}/){1,30})([A-Za-z0-9_.-]{1,200})/([A-Za-z0-9_][A-Za-z0-9_.+-]{0,199})/"
              + "[A-Za-z0-9_.+-]{1,250}\\.jar");

  private static final int MAX_JARS = 1000;
  private static final int MAX_DEPTH = 40;

  /** Repository ids in Maven's settings. */
  private static final Pattern REPOSITORY =
      Pattern.compile("<repository>.*?<id>\\s*([A-Za-z0-9_.-]{1,100})\\s*</id>", Pattern.DOTALL);

  private final Path cache;
  private final Lock downloadLock = new ReentrantLock();

  MavenPackages(Path cache) {
    this.cache = cache;
  }

  /**
   * A jar of a package or of one that it needs.
   *
   * @param name {@code GROUP:ARTIFACT}, with {@code :CLASSIFIER} if there is one
   */
  record Jar(Path file, String name, String version) {
    ResolvedPackage resolved() throws IOException {
      return new ResolvedPackage(name, version, Sha256.hex(Files.readAllBytes(file)));
    }
  }

  /**
   * The jars of a package; downloads them at the first use.
   *
   * @param wanted such as {@code org.apache.commons:commons-math3:3.6.1}
   * @throws CompilationException if the coordinates are invalid or the download fails
   */
  List<Jar> jars(String wanted, Compilation compilation)
      throws CompilationException, IOException, InterruptedException {
    Matcher coordinates = COORDINATES.matcher(wanted.strip());
    if (!coordinates.matches()) {
      throw failure(
          "'"
              + wanted
              + "' is not a package such as org.apache.commons:commons-math3:3.6.1, with group,"
              + " artifact and version");
    }
    ActivityLock lock = ActivityLock.of(compilation.application().activity().files()).orElse(null);
    String releases =
        lock == null ? "" : "!" + Sha256.hex(lock.text().getBytes(StandardCharsets.UTF_8));
    Path folder = cache.resolve("resolved").resolve(wanted.strip().replace(':', '!') + releases);
    // Maven's local repository does not support concurrent writers.
    downloadLock.lockInterruptibly();
    try {
      if (!Files.isDirectory(folder, LinkOption.NOFOLLOW_LINKS)) {
        download(coordinates, lock, folder, compilation);
      }
    } finally {
      downloadLock.unlock();
    }
    return jarsIn(folder);
  }

  private static List<Jar> jarsIn(Path folder) throws IOException {
    List<Jar> jars = new ArrayList<>();
    try (Stream<Path> files = Files.walk(folder, MAX_DEPTH)) {
      for (Path file :
          files
              .filter(file -> Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS))
              .limit(MAX_JARS)
              .sorted(Comparator.comparing((Path file) -> file.getFileName().toString()))
              .toList()) {
        Matcher place = JAR.matcher(folder.relativize(file).toString());
        if (place.matches()) {
          String group = place.group(1).replaceAll("/$", "").replace('/', '.');
          String rest = file.getFileName().toString();
          rest = rest.substring(0, rest.length() - ".jar".length());
          String plain = place.group(2) + "-" + place.group(3);
          String classifier =
              rest.startsWith(plain + "-") ? ":" + rest.substring(plain.length() + 1) : "";
          jars.add(new Jar(file, group + ":" + place.group(2) + classifier, place.group(3)));
        }
      }
    }
    return jars;
  }

  /** The releases of a lock, for the dependencies of a package. */
  private static String managed(@Nullable ActivityLock lock) {
    StringBuilder managed = new StringBuilder();
    for (ResolvedPackage each : lock == null ? List.<ResolvedPackage>of() : lock.packages()) {
      String[] parts = each.name().split(":", -1);
      if (parts.length == 2) {
        managed.append(
            "<dependency><groupId>%s</groupId><artifactId>%s</artifactId><version>%s</version></dependency>"
                .formatted(parts[0], parts[1], each.version()));
      }
    }
    return managed.toString();
  }

  /** Fails if the downloaded jars are not those of the lock. */
  private static void verify(@Nullable ActivityLock lock, Path jars)
      throws CompilationException, IOException {
    if (lock == null) {
      return;
    }
    List<ResolvedPackage> resolved = new ArrayList<>();
    for (Jar jar : jarsIn(jars)) {
      resolved.add(jar.resolved());
    }
    String mismatch = lock.mismatch(resolved).orElse(null);
    if (mismatch != null) {
      throw new CompilationException(
          "the component's packages are not those of " + ActivityLock.FILE,
          List.of(SourceDiagnostic.ofFile("activity/" + ActivityLock.FILE, mismatch)));
    }
  }

  private void download(
      Matcher coordinates, @Nullable ActivityLock lock, Path folder, Compilation compilation)
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
          <dependencyManagement><dependencies>%s</dependencies></dependencyManagement>
          <dependencies>
            <dependency>
              <groupId>%s</groupId>
              <artifactId>%s</artifactId>
              <version>%s</version>
            </dependency>
          </dependencies>
        </project>
        """
            .formatted(
                managed(lock), coordinates.group(1), coordinates.group(2), coordinates.group(3)),
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
            // Check for updates: what was missing earlier may exist now.
            "--update-snapshots",
            "-Dmaven.repo.local=" + repository,
            "-DincludeScope=runtime",
            "-Dmdep.useRepositoryLayout=true",
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
                  limit(compilation));
    } catch (IOException e) {
      throw failure(coordinates.group() + ": Maven cannot be started: " + e.getMessage() + REMEDY);
    }
    if (end.code() != 0) {
      throw failure(coordinates.group() + ": " + errorOf(end, compilation));
    }
    verify(lock, jars);
    Files.createDirectories(folder.getParent());
    try {
      Files.move(jars, folder, StandardCopyOption.ATOMIC_MOVE);
    } catch (FileSystemException e) {
      if (!Files.isDirectory(folder)) {
        throw e;
      }
      // Another agent has downloaded the same package.
    }
  }

  /**
   * Settings that block all repositories except Maven Central and those in the installation's own
   * settings, which stay in effect.
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

  /** The installation's settings; empty if there are none. */
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

  /** Maven's own files; its settings may be links to another folder. */
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

  private static Duration limit(Compilation compilation) {
    return compilation.application().activity().profile().limits().preparation();
  }

  private static String errorOf(ToolResult end, Compilation compilation) {
    if (end.timedOut()) {
      return "Maven did not finish within "
          + limit(compilation).toSeconds()
          + " s; raise limits: prepare_s in activity.yaml";
    }
    if (end.code() == NOT_FOUND) {
      return "Maven is not installed" + REMEDY;
    }
    List<String> errors =
        (end.output() + "\n" + end.errors())
            .lines()
            .map(line -> COLOUR.matcher(line).replaceAll(""))
            .filter(line -> line.startsWith("[ERROR]"))
            .map(line -> line.substring("[ERROR]".length()).strip())
            // The remaining lines tell how to get more output.
            .takeWhile(line -> !line.isEmpty())
            .limit(MAX_ERROR_LINES)
            .toList();
    return errors.isEmpty()
        ? "Maven ended with exit code " + end.code() + ": " + end.errors().strip()
        : String.join("; ", errors);
  }

  private static CompilationException failure(String reason) {
    return new CompilationException(
        "the component's package cannot be downloaded",
        List.of(JavaToolchain.inProfile("component: package: " + reason)));
  }
}
