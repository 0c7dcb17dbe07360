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
 * Says which ports the server has, for launchers that let it choose: on standard output, and in a
 * file of the data directory.
 */
@Component
class Announcement {
  private final SitafSettings settings;
  private final GrpcServerLifecycle grpc;

  Announcement(SitafSettings settings, GrpcServerLifecycle grpc) {
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
    write("http=" + http + "\ngrpc=" + grpc.getPort() + "\n");
    System.out.println("listening http=" + http + " grpc=" + grpc.getPort());
    System.out.flush();
  }

  /** By renaming, so that nobody reads half of it. */
  private void write(String ports) throws IOException {
    Path directory = Files.createDirectories(settings.dataDirectory());
    Path fresh = directory.resolve("ports.properties.new");
    Files.write(fresh, ports.getBytes(StandardCharsets.UTF_8));
    Files.move(
        fresh,
        directory.resolve("ports.properties"),
        StandardCopyOption.REPLACE_EXISTING,
        StandardCopyOption.ATOMIC_MOVE);
  }
}
