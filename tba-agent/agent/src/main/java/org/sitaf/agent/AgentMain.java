package org.sitaf.agent;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
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
      "Compiles and executes test applications that a SITAF server assigns.",
      "At the first start SITAF_ENROLMENT_TOKEN holds a token that an administrator made; the key"
          + " that the agent gets for it stays in its directory."
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
          "The server's gRPC address, or those of several with one database, joined by commas;"
              + " default ${DEFAULT-VALUE}.")
  private String server = "";

  @Option(
      names = "--ca",
      paramLabel = "FILE",
      description =
          "Certificates that vouch for the server, in PEM; default those that this machine trusts.")
  private @Nullable Path authorities;

  @Option(
      names = "--plaintext",
      description = "Speaks without TLS to a server that is not on this machine.")
  private boolean plaintext;

  @Option(
      names = "--name",
      description = "Unique among the agents of the server; default the name of this machine.")
  private @Nullable String name;

  @Option(
      names = "--directory",
      required = true,
      description = "Private to this agent: results not yet uploaded, files, builds.")
  private Path directory = Path.of("");

  @Option(
      names = "--slots",
      defaultValue = "1",
      description = "Builds that may run at the same time; default ${DEFAULT-VALUE}.")
  private int slots;

  @Option(
      names = "--label",
      paramLabel = "LABEL",
      description =
          "What this agent is called by, such as real-hardware; builds can ask for it. Repeatable.")
  private List<String> labels = List.of();

  @Option(
      names = "--min-free-mib",
      paramLabel = "MIB",
      defaultValue = "200",
      description =
          "Takes no new build while less is free on the disk of --directory; default"
              + " ${DEFAULT-VALUE}.")
  private long minFreeMib;

  @Option(
      names = "--longest-build-min",
      paramLabel = "MINUTES",
      defaultValue = "720",
      description =
          "The cases of a build take no longer than this together, whatever limits its activity"
              + " sets; default ${DEFAULT-VALUE}.")
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
          "Uses a running simulation bridge, which all builds share, instead of one for each build:"
              + " 127.0.0.1:PORT or unix:PATH.")
  private @Nullable String bridge;

  @Option(
      names = "--runtimes",
      paramLabel = "FOLDER",
      description =
          "What test applications link against: holds runtime-java and those of other languages;"
              + " default the folder of agent.jar.")
  private @Nullable Path runtimes;

  @Option(
      names = "--sandbox",
      paramLabel = "MODE",
      defaultValue = "auto",
      description =
          "Components and their compilers run in a sandbox (bubblewrap): required, auto (where it"
              + " is installed) or off; default ${DEFAULT-VALUE}. An agent that has one carries the"
              + " label 'sandbox'.")
  private SandboxMode sandbox = SandboxMode.AUTO;

  @Option(
      names = "--annotation-processor-path",
      paramLabel = "JARS",
      split = ":",
      description =
          "Jars of the annotation processors and plugins that may run when Java components are"
              + " compiled, joined by colons; default none, whatever the component's jars ask for.")
  private List<Path> annotationProcessors = List.of();

  @Option(
      names = "--no-coverage",
      description = "Builds do not record which lines of the component they reach.")
  private boolean noCoverage;

  @Option(
      names = "--stop-with-stdin",
      description = "Ends when standard input closes, so that the agent goes with its launcher.")
  private boolean stopWithStdin;

  /** Starts an agent; see {@code --help}. */
  public static void main(String[] arguments) {
    if (System.getProperty("java.util.logging.SimpleFormatter.format") == null) {
      System.setProperty("java.util.logging.SimpleFormatter.format", "%1$tFT%1$tT %4$s %5$s%6$s%n");
    }
    // A launcher gives defaults first; what a person adds wins, without a word about it.
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
                annotationProcessors));
    CountDownLatch stop = new CountDownLatch(1);
    CountDownLatch stopped = new CountDownLatch(1);
    AtomicBoolean told = new AtomicBoolean();
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
                if (!told.getAndSet(true)) {
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
        minFreeMib << 20,
        Duration.ofMinutes(longestBuildMin));
  }

  /**
   * Splits a command into words as a shell does with plain words and quotes; nothing else is
   * special.
   */
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
        // Only the end counts.
      }
    } catch (IOException e) {
      // As good as its end.
    }
    stop.countDown();
  }

  /** A process that was told to end does, whatever became of what it waits for. */
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
