package org.sitaf.server.support;

import java.io.BufferedReader;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.sitaf.server.SitafServer;

/**
 * A server in a process of its own, which can be killed. It stops when its standard input is
 * closed, and thus with the test.
 */
public final class ServerProcess implements AutoCloseable {
  private static final Pattern LISTENING = Pattern.compile("listening http=(\\d+) grpc=(\\d+)");
  private static final int TIMEOUT_S = 60;

  private final Process process;
  private final Api api;
  private final int grpcPort;

  /** Starts a server with a data directory, which earlier ones may have used. */
  public ServerProcess(Path data, String... arguments) throws IOException {
    List<String> command = new ArrayList<>();
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:TieredStopAtLevel=1", "-cp", classPath()));
    command.add(SitafServer.class.getName());
    command.addAll(
        List.of(
            "--server.port=0",
            "--spring.grpc.server.port=0",
            "--sitaf.stop-with-stdin=true",
            "--sitaf.data-directory=" + data));
    command.addAll(List.of(arguments));
    ProcessBuilder builder =
        new ProcessBuilder(command).redirectError(ProcessBuilder.Redirect.INHERIT);
    builder.environment().put("SITAF_ACCESS_LAUNCHERTOKEN", ServerTest.TOKEN);
    builder.environment().put("SITAF_ACCESS_LAUNCHERENROLMENT", ServerTest.ENROLMENT);
    process = builder.start();
    BufferedReader output = process.inputReader(StandardCharsets.UTF_8);
    StringBuilder startLog = new StringBuilder();
    for (String line = output.readLine(); line != null; line = output.readLine()) {
      startLog.append(line).append('\n');
      Matcher listening = LISTENING.matcher(line);
      if (listening.matches()) {
        api = new Api(Integer.parseInt(listening.group(1)));
        grpcPort = Integer.parseInt(listening.group(2));
        return;
      }
    }
    throw new IllegalStateException("the server did not start:\n" + startLog);
  }

  private static String classPath() {
    return System.getProperty("surefire.test.class.path", System.getProperty("java.class.path"));
  }

  public Api api() {
    return api;
  }

  public int grpcPort() {
    return grpcPort;
  }

  /** Kills the process without warning. */
  public void kill() throws InterruptedException {
    int unused = process.destroyForcibly().waitFor();
  }

  /** Stops the server by closing its standard input. */
  @Override
  public void close() throws IOException, InterruptedException {
    process.getOutputStream().close();
    if (!process.waitFor(TIMEOUT_S, TimeUnit.SECONDS)) {
      process.destroyForcibly();
      throw new AssertionError("the server did not end with its standard input");
    }
  }
}
