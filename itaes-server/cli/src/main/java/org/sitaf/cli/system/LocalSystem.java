package org.sitaf.cli.system;

import java.io.IOException;
import java.net.BindException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.cli.file.Installation;
import org.sitaf.cli.terminal.ProgressLine;

/** A server and an agent with a simulation on this machine, for the duration of a command. */
final class LocalSystem implements AutoCloseable {

  /** Waits long for a process that makes progress, because the machine may be busy. */
  private static final StartupTimeout STARTUP_TIMEOUT =
      new StartupTimeout(Duration.ofMinutes(2), Duration.ofMinutes(20));

  private static final Pattern LISTENING = Pattern.compile("^listening http=(\\d+) grpc=(\\d+)");
  private static final Pattern REGISTERED = Pattern.compile("^registered ");
  private static final int SECRET_BYTES = 32;
  private static final SecureRandom RANDOM = new SecureRandom();

  private final StartedProcess server;
  private final StartedProcess agent;
  private final URI address;
  private final String token;

  private LocalSystem(StartedProcess server, StartedProcess agent, URI address, String token) {
    this.server = server;
    this.agent = agent;
    this.address = address;
    this.token = token;
  }

  /**
   * Starts both and returns when the agent is registered.
   *
   * @param directory data of server and agent, including logs
   * @param httpPort 0 for any free port
   * @param grpcPort 0 for any free port
   * @param devices addresses of the providers of real devices that builds may use, by device
   * @throws IOException if one of them does not start; the message contains the end of its log
   */
  static LocalSystem start(
      Installation installation,
      Path directory,
      int httpPort,
      int grpcPort,
      Map<String, String> devices,
      ProgressLine progress)
      throws IOException, InterruptedException {
    createPrivate(directory);
    requireFree(httpPort, "--port");
    requireFree(grpcPort, "--grpc-port");
    progress.step("Starting the server");
    List<String> serverCommand = new ArrayList<>(installation.serverCommand());
    serverCommand.add("--sitaf.data-directory=" + directory.resolve("server"));
    serverCommand.add("--server.port=" + httpPort);
    serverCommand.add("--spring.grpc.server.port=" + grpcPort);
    serverCommand.add("--sitaf.stop-with-stdin=true");
    // Sessions last a month, because the server listens on loopback for one person.
    serverCommand.add("--spring.session.timeout=30d");
    serverCommand.add("--server.servlet.session.cookie.max-age=30d");
    String token = secret();
    String enrolment = secret();
    StartedProcess server =
        new StartedProcess(
            "server",
            serverCommand,
            Map.of(
                "SITAF_ACCESS_LAUNCHERTOKEN", token, "SITAF_ACCESS_LAUNCHERENROLMENT", enrolment),
            directory.resolve("server.log"),
            LISTENING);
    try {
      Matcher ports = server.awaitReady(STARTUP_TIMEOUT, progress);
      progress.step("Starting an agent");
      List<String> agentCommand = new ArrayList<>(installation.agentCommand());
      agentCommand.addAll(
          List.of(
              "--server",
              "127.0.0.1:" + ports.group(2),
              "--directory",
              directory.resolve("agent").toString(),
              "--earlier-cache",
              installation.cache().toString(),
              "--stop-with-stdin"));
      devices.forEach((device, at) -> agentCommand.addAll(List.of("--device", device + "=" + at)));
      StartedProcess agent =
          new StartedProcess(
              "agent",
              agentCommand,
              Map.of("SITAF_ENROLMENT_TOKEN", enrolment),
              directory.resolve("agent.log"),
              REGISTERED);
      try {
        agent.awaitReady(STARTUP_TIMEOUT, progress, server);
        return new LocalSystem(
            server, agent, URI.create("http://localhost:" + ports.group(1)), token);
      } catch (IOException | InterruptedException e) {
        agent.close();
        throw e;
      }
    } catch (IOException | InterruptedException e) {
      server.close();
      throw e;
    }
  }

  /** Creates a folder that other users cannot read, because it holds logs, results and keys. */
  private static void createPrivate(Path directory) throws IOException {
    Files.createDirectories(directory);
    if (Files.getFileStore(directory).supportsFileAttributeView("posix")) {
      Files.setPosixFilePermissions(directory, PosixFilePermissions.fromString("rwx------"));
    }
  }

  /** Reports a port in use at once, instead of by the log of a server that does not start. */
  static void requireFree(int port, String option) throws IOException {
    if (port == 0) {
      return;
    }
    try (ServerSocket probe = new ServerSocket()) {
      probe.setReuseAddress(true);
      probe.bind(new InetSocketAddress(InetAddress.getByName("127.0.0.1"), port));
    } catch (BindException e) {
      throw new IOException(
          "port "
              + port
              + " is in use, perhaps by another './sitaf up': stop it, or choose another port with "
              + option
              + " (0: any free port)",
          e);
    }
  }

  /** The address of the portal and the REST interface. */
  URI address() {
    return address;
  }

  /** A client of the server. */
  ServerClient client() {
    return new ServerClient(address, token);
  }

  /** A link that opens the portal and signs in, valid once. */
  URI signInLink() throws IOException, InterruptedException {
    return address.resolve(client().post("session/link", Map.of()).path("path").asString());
  }

  private static String secret() {
    byte[] bytes = new byte[SECRET_BYTES];
    RANDOM.nextBytes(bytes);
    return HexFormat.of().formatHex(bytes);
  }

  /** Waits until the server ends or this command is interrupted. */
  int await() throws InterruptedException {
    return server.await();
  }

  @Override
  public void close() {
    agent.close();
    server.close();
  }

  /** Stops both at the same time, and kills each if it does not end within a limit. */
  void close(Duration limit) {
    agent.stop();
    server.close(limit);
    agent.close(limit);
  }
}
