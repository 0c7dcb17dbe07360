package org.sitaf.server.web;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.sitaf.server.settings.SitafSettings;
import org.springframework.boot.context.event.ApplicationReadyEvent;
import org.springframework.boot.web.server.context.WebServerApplicationContext;
import org.springframework.context.event.EventListener;
import org.springframework.grpc.server.lifecycle.GrpcServerLifecycle;
import org.springframework.stereotype.Component;

/**
 * Publishes the server's ports on standard output and in a file of the data directory, for
 * launchers that start the server with port 0.
 */
@Component
class ListeningPorts {
  private final SitafSettings settings;
  private final GrpcServerLifecycle grpc;

  ListeningPorts(SitafSettings settings, GrpcServerLifecycle grpc) {
    this.settings = settings;
    this.grpc = grpc;
  }

  @EventListener
  void on(ApplicationReadyEvent ready) throws IOException {
    if (!(ready.getApplicationContext() instanceof WebServerApplicationContext web)
        || web.getWebServer() == null) {
      return;
    }
    int http = web.getWebServer().getPort();
    writeFile("http=" + http + "\ngrpc=" + grpc.getPort() + "\n");
    System.out.println("listening http=" + http + " grpc=" + grpc.getPort());
    System.out.flush();
  }

  /** Renames a temporary file, so that readers never see a partial file. */
  private void writeFile(String ports) throws IOException {
    Path directory = Files.createDirectories(settings.dataDirectory());
    Path temporary = directory.resolve("ports.properties.new");
    Files.write(temporary, ports.getBytes(StandardCharsets.UTF_8));
    Files.move(
        temporary,
        directory.resolve("ports.properties"),
        StandardCopyOption.REPLACE_EXISTING,
        StandardCopyOption.ATOMIC_MOVE);
  }
}
