package org.sitaf.cli.system;

import java.io.IOException;
import java.io.PrintWriter;

/** Prints links that sign in to the portal without a password. */
final class SignInLinks {
  private SignInLinks() {}

  /** Prints a link, and another one whenever Enter is pressed. */
  static void printAndKeep(LocalSystem system, PrintWriter out)
      throws IOException, InterruptedException {
    out.println("The portal is at " + system.address() + " until you press Ctrl-C.");
    out.println(
        "Sign in with this link, valid once: "
            + system.signInLink()
            + " (press Enter for another one)");
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
      // The server has ended or the terminal was closed; so does this command.
      return;
    }
  }
}
