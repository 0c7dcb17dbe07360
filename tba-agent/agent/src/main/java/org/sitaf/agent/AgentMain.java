package org.sitaf.agent;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicBoolean;
import org.jspecify.annotations.Nullable;
import org.sitaf.agent.manager.AgentSettings;
import org.sitaf.agent.manager.ServerAccess;
import org.sitaf.agent.manager.TestBuildAgent;
import org.sitaf.agent.sandbox.SandboxMode;
import org.sitaf.agent.toolchain.ToolchainPlaces;
import org.sitaf.agent.toolchain.Toolchains;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;

/** The command {@code sitaf agent}. */
@Command(
    name = "sitaf agent",
    mixinStandardHelpOptions = true,
    versionProvider = AgentMain.Version.class,
    description = {
      "Compiles and executes test applications for a SITAF server.",
      "At the first start, set SITAF_ENROLMENT_TOKEN to a token that an administrator created;"
          + " the agent exchanges it for a key, which is stored in its directory."
    },
    sortOptions = false)
public final class AgentMain implements Callable<Integer> {
  private static final int BAD_SETTINGS = 2;
  private static final int LONGEST_END_S = 30;

  @Option(
      names = "--server",
      paramLabel = "HOST:PORT",
      defaultValue = "localhost:9090",
      description =
          "gRPC address of the server, or comma-separated addresses of several with one database;"
              + " default ${DEFAULT-VALUE}.")
  private String server = "";

  @Option(
      names = "--ca",
      paramLabel = "FILE",
      description = "Trusted certificates in PEM; default: those of this machine.")
  private @Nullable Path authorities;

  @Option(
      names = "--plaintext",
      description = "Connects without TLS to a server on another machine.")
  private boolean plaintext;

  @Option(
      names = "--name",
      description = "Unique name of the agent; default: the name of this machine.")
  private @Nullable String name;

  @Option(
      names = "--directory",
      required = true,
      description = "Private folder of this agent for results, caches and builds.")
  private Path directory = Path.of("");

  @Option(
      names = "--earlier-cache",
      paramLabel = "DIRECTORY",
      description =
          "Cache of the commands of this installation. The compiled runtime and the packages in it"
              + " are used; nothing in it is changed.")
  private @Nullable Path earlierCache;

  @Option(
      names = "--slots",
      defaultValue = "1",
      description = "Maximum number of concurrent builds; default ${DEFAULT-VALUE}.")
  private int slots;

  @Option(
      names = "--label",
      paramLabel = "LABEL",
      description = "Label that builds can require, such as real-hardware. Repeatable.")
  private List<String> labels = List.of();

  @Option(
      names = "--device",
      paramLabel = "NAME=ADDRESS",
      description =
          "Real device that builds may use: its name in their worlds, and the address of its"
              + " provider, unix:/PATH or HOST:PORT. One build at a time has it. Repeatable.")
  private Map<String, String> devices = Map.of();

  @Option(
      names = "--min-free-mib",
      paramLabel = "MIB",
      defaultValue = "200",
      description =
          "Accepts no build while less is free on the disk of --directory; default"
              + " ${DEFAULT-VALUE}.")
  private long minFreeMib;

  @Option(
      names = "--longest-build-min",
      paramLabel = "MINUTES",
      defaultValue = "720",
      description =
          "Time limit for all cases of a build, regardless of the limits of its activity;"
              + " default ${DEFAULT-VALUE}.")
  private long longestBuildMin;

  @Option(
      names = "--bridge-command",
      paramLabel = "COMMAND",
      defaultValue = "",
      description =
          "Starts a simulation bridge for each build, such as 'python -m sitaf_bridge'; its"
              + " arguments are appended. Words are separated by spaces; quotes group them.")
  private String bridgeCommand = "";

  @Option(
      names = "--bridge",
      paramLabel = "ADDRESS",
      description =
          "Uses a running simulation bridge for all builds, instead of one per build:"
              + " 127.0.0.1:PORT or unix:PATH.")
  private @Nullable String bridge;

  @Option(
      names = "--runtimes",
      paramLabel = "FOLDER",
      description =
          "Folder of the runtimes of test applications, such as runtime-java;"
              + " default: the folder of agent.jar.")
  private @Nullable Path runtimes;

  @Option(
      names = "--sandbox",
      paramLabel = "MODE",
      defaultValue = "auto",
      description =
          "Components and their compilers run in a sandbox (bubblewrap): required, auto (where it"
              + " is installed) or off; default ${DEFAULT-VALUE}. An agent with a sandbox has the"
              + " label 'sandbox'.")
  private SandboxMode sandbox = SandboxMode.AUTO;

  @Option(
      names = "--annotation-processor-path",
      paramLabel = "JARS",
      split = ":",
      description =
          "Allowed annotation processors and compiler plugins for Java components: jars,"
              + " separated by colons; default: none.")
  private List<Path> annotationProcessors = List.of();

  @Option(
      names = "--no-coverage",
      description = "Builds do not measure the line coverage of components.")
  private boolean noCoverage;

  @Option(
      names = "--stop-with-stdin",
      description = "Ends when standard input is closed, for example because the launcher ended.")
  private boolean stopWithStdin;

  /** Starts an agent; see {@code --help}. */
  public static void main(String[] arguments) {
    if (System.getProperty("java.util.logging.SimpleFormatter.format") == null) {
      System.setProperty("java.util.logging.SimpleFormatter.format", "%1$tFT%1$tT %4$s %5$s%6$s%n");
    }
    // The launcher's defaults come first; options of the user override them without a warning.
    System.setProperty("picocli.trace", "OFF");
    CommandLine command =
        new CommandLine(new AgentMain())
            .setOverwrittenOptionsAllowed(true)
            .setCaseInsensitiveEnumValuesAllowed(true);
    System.exit(command.execute(arguments));
  }

  @Override
  public Integer call() throws InterruptedException {
    Toolchains toolchains =
        new Toolchains(
            new ToolchainPlaces(
                runtimes != null ? runtimes : folderOfJar(),
                directory.resolve("cache"),
                annotationProcessors,
                earlierCache));
    CountDownLatch stop = new CountDownLatch(1);
    CountDownLatch stopped = new CountDownLatch(1);
    AtomicBoolean registeredBefore = new AtomicBoolean();
    AgentSettings settings;
    TestBuildAgent agent;
    try {
      settings = settings();
      toolchains.missing().forEach(missing -> System.err.println("sitaf agent: no " + missing));
      agent =
          new TestBuildAgent(
              settings,
              toolchains,
              version -> {
                if (!registeredBefore.getAndSet(true)) {
                  System.out.println(
                      "registered "
                          + settings.name()
                          + " at "
                          + server
                          + " (server "
                          + version
                          + ")");
                }
              });
    } catch (IllegalArgumentException | IOException e) {
      System.err.println("sitaf agent: " + e.getMessage());
      return BAD_SETTINGS;
    }
    Runtime.getRuntime()
        .addShutdownHook(
            new Thread(
                () -> {
                  stop.countDown();
                  awaitQuietly(stopped);
                },
                "sitaf-shutdown"));
    if (stopWithStdin) {
      Thread watch = new Thread(() -> watchStdin(stop), "sitaf-stdin");
      watch.setDaemon(true);
      watch.start();
    }
    try {
      stop.await();
    } finally {
      try {
        agent.close();
      } finally {
        stopped.countDown();
      }
    }
    return 0;
  }

  private AgentSettings settings() {
    return new AgentSettings(
        server,
        new ServerAccess(System.getenv("SITAF_ENROLMENT_TOKEN"), authorities, plaintext),
        name != null ? name : hostName(),
        Version.text(),
        directory,
        slots,
        bridge == null ? words(bridgeCommand) : List.of(),
        bridge,
        sandbox,
        !noCoverage,
        Set.copyOf(labels),
        devices,
        minFreeMib << 20,
        Duration.ofMinutes(longestBuildMin));
  }

  /** Splits a command like a shell, with support for quotes only. */
  static List<String> words(String command) {
    java.util.ArrayList<String> words = new java.util.ArrayList<>();
    StringBuilder word = new StringBuilder();
    boolean inWord = false;
    char quote = 0;
    for (int i = 0; i < command.length(); i++) {
      char c = command.charAt(i);
      if (quote != 0 && c == quote) {
        quote = 0;
      } else if (quote == 0 && (c == '\'' || c == '"')) {
        quote = c;
        inWord = true;
      } else if (quote == 0 && Character.isWhitespace(c)) {
        if (inWord) {
          words.add(word.toString());
          word.setLength(0);
          inWord = false;
        }
      } else {
        word.append(c);
        inWord = true;
      }
    }
    if (quote != 0) {
      throw new IllegalArgumentException("--bridge-command: a quote is not closed");
    }
    if (inWord) {
      words.add(word.toString());
    }
    return words;
  }

  private static Path folderOfJar() {
    try {
      Path jar =
          Path.of(AgentMain.class.getProtectionDomain().getCodeSource().getLocation().toURI());
      return jar.toAbsolutePath().getParent();
    } catch (URISyntaxException e) {
      throw new IllegalArgumentException("give --runtimes", e);
    }
  }

  private static String hostName() {
    try {
      return InetAddress.getLocalHost().getHostName().replaceAll("[^A-Za-z0-9._-]", "-");
    } catch (UnknownHostException e) {
      return "agent";
    }
  }

  private static void watchStdin(CountDownLatch stop) {
    try {
      while (System.in.read() >= 0) {
        // The content is ignored.
      }
    } catch (IOException e) {
      // Treated like the end of the stream.
    }
    stop.countDown();
  }

  /** Waits with a limit, so that the process ends in any case. */
  private static void awaitQuietly(CountDownLatch latch) {
    try {
      var unused = latch.await(LONGEST_END_S, TimeUnit.SECONDS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  /** The version in the jar's manifest. */
  static final class Version implements CommandLine.IVersionProvider {
    @Override
    public String[] getVersion() {
      return new String[] {"sitaf agent " + text()};
    }

    static String text() {
      return Optional.ofNullable(AgentMain.class.getPackage().getImplementationVersion())
          .orElse("development");
    }
  }
}
