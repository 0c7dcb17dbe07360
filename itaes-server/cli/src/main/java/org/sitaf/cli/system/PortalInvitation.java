package org.sitaf.cli.system;

import java.io.IOException;
import java.io.PrintWriter;

/** Says how the portal is opened without a password: by a link that signs in once. */
final class PortalInvitation {
  private PortalInvitation() {}

  /** Prints a link, and another one each time that somebody presses Enter. */
  static void printAndKeep(LocalSystem system, PrintWriter out)
      throws IOException, InterruptedException {
    out.println("The portal is at " + system.address() + " until you press Ctrl-C.");
    out.println("Open it signed in, once: " + system.signInLink() + " (Enter makes another link)");
    out.flush();
    Thread reader = new Thread(() -> printOnEnter(system, out), "sitaf-links");
    reader.setDaemon(true);
    reader.start();
  }

  private static void printOnEnter(LocalSystem system, PrintWriter out) {
    try {
      for (int read = System.in.read(); read >= 0; read = System.in.read()) {
        if (read == '\n') {
          out.println(system.signInLink());
          out.flush();
        }
      }
    } catch (IOException | InterruptedException e) {
      // The server or the terminal is gone, and this command with it.
      return;
    }
  }
}
