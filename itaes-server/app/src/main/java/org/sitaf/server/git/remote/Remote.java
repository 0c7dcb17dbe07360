package org.sitaf.server.git.remote;

import java.io.IOException;
import java.net.UnknownHostException;
import java.nio.file.Path;
import java.util.List;
import org.eclipse.jgit.errors.NoRemoteRepositoryException;
import org.eclipse.jgit.errors.NotSupportedException;
import org.eclipse.jgit.errors.TooLargeObjectInPackException;
import org.eclipse.jgit.errors.TransportException;
import org.eclipse.jgit.transport.RefSpec;
import org.eclipse.jgit.transport.SshTransport;
import org.eclipse.jgit.transport.TagOpt;
import org.eclipse.jgit.transport.Transport;
import org.eclipse.jgit.transport.TransportHttp;
import org.eclipse.jgit.transport.URIish;
import org.eclipse.jgit.transport.UsernamePasswordCredentialsProvider;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.git.NoUserConfiguration;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.springframework.stereotype.Component;

/**
 * Fetches branches of repositories into copies on the server's disk. No hook, filter, submodule or
 * configuration of the user takes part.
 */
@Component
public class Remote {
  /** Longest wait for a byte, in seconds. */
  private static final int SILENCE_S = 30;

  private final GitSettings settings;

  Remote(GitSettings settings) {
    this.settings = settings;
    NoUserConfiguration.install();
  }

  /**
   * What to fetch.
   *
   * @param hostKey fingerprint of the host's key; null if it is not known yet
   */
  public record Source(GitAddress address, Credential credential, @Nullable String hostKey) {}

  /**
   * Checks a credential for an address.
   *
   * @throws RequestException if it cannot be used for this transport
   */
  public static void requireUsable(GitAddress address, Credential credential) {
    if (credential instanceof Credential.DeployKey key) {
      if (address.transport() != GitAddress.Transport.SSH) {
        throw RequestException.malformed(
            "credential: a deploy key needs an ssh address; use a token for https.");
      }
      SshSessions.keys(key.privateKey());
    } else if (address.transport() == GitAddress.Transport.SSH) {
      throw RequestException.malformed("credential: an ssh address needs a deploy key.");
    } else if (credential instanceof Credential.Token && !address.isWeb()) {
      throw RequestException.malformed("credential: a token needs an https address.");
    }
  }

  /**
   * Fetches references.
   *
   * @param folder of the copy
   * @param references such as {@code refs/heads/main}, as the local name
   * @return the fingerprint of the host's key; null if the transport has none
   */
  public @Nullable String fetch(Path folder, Source source, List<RefSpec> references)
      throws RemoteException {
    FetchLimits limits =
        new FetchLimits(
            settings.fetchTime(),
            settings.maxRepository().toBytes(),
            settings.maxObject().toBytes());
    SshSessions.HostKey hostKey = new SshSessions.HostKey(source.hostKey());
    try (LimitedRepository repository = LimitedRepository.open(folder)) {
      repository.limit(limits);
      requireHost(source.address());
      try (Transport transport = Transport.open(repository, new URIish(source.address().text()))) {
        prepare(transport, source, limits, folder, hostKey);
        transport.fetch(limits.monitor(), references);
      }
      return hostKey.seen();
    } catch (IOException | RuntimeException | java.net.URISyntaxException e) {
      if (hostKey.isOther()) {
        throw new RemoteException(
            "The host "
                + source.address().host()
                + " has another key ("
                + hostKey.seen()
                + ") than before. If its administrator confirms the new key, save the settings"
                + " again with 'forget the host key'.",
            e);
      }
      throw problem(e, source, limits);
    }
  }

  /** The JDK caches addresses for 30 s, so the connection uses the ones that are checked here. */
  private void requireHost(GitAddress address) throws UnknownHostException {
    if (!address.host().isEmpty()) {
      GitAddress.hosts(settings).resolve(address.host());
    }
  }

  private static void prepare(
      Transport transport,
      Source source,
      FetchLimits limits,
      Path folder,
      SshSessions.HostKey hostKey) {
    transport.setTagOpt(TagOpt.NO_TAGS);
    transport.setTimeout(SILENCE_S);
    if (transport instanceof TransportHttp http) {
      http.setHttpConnectionFactory(new LimitedConnections(limits));
      if (source.credential() instanceof Credential.Token token) {
        http.setCredentialsProvider(
            new UsernamePasswordCredentialsProvider(token.user(), token.token()));
      }
    }
    if (transport instanceof SshTransport ssh
        && source.credential() instanceof Credential.DeployKey key) {
      ssh.setSshSessionFactory(SshSessions.of(folder, SshSessions.keys(key.privateKey()), hostKey));
    }
  }

  private static RemoteException problem(Exception e, Source source, FetchLimits limits) {
    String where = source.address().text();
    for (Throwable cause = e; cause != null; cause = cause.getCause()) {
      if (cause instanceof FetchLimits.LimitException limit) {
        return new RemoteException(String.valueOf(limit.getMessage()), e);
      }
      if (cause instanceof TooLargeObjectInPackException) {
        return new RemoteException(
            "The repository holds a file that is larger than "
                + (limits.maxObject() >> 20)
                + " MiB. Remove it from the branch and its history, or ask the administrator to"
                + " raise sitaf.git.max-object.",
            e);
      }
      if (cause instanceof UnknownHostException) {
        return new RemoteException(
            "The host of " + where + " cannot be reached: " + cause.getMessage() + ".", e);
      }
    }
    if (limits.isLate()) {
      return new RemoteException(String.valueOf(limits.late().getMessage()), e);
    }
    String message = String.valueOf(e.getMessage());
    if (message.contains("does not have") && message.contains("available for fetch")) {
      if (!message.contains("refs/heads/")) {
        return new RemoteException(
            where
                + " has no reference of this request. Check that the repository is the one at the"
                + " forge that the request was made for.",
            e);
      }
      return new RemoteException(
          "The branch does not exist in "
              + where
              + ": it was deleted or renamed. Push it again, or set another branch.",
          e);
    }
    if (e instanceof NoRemoteRepositoryException || message.contains("not found")) {
      return new RemoteException(
          "There is no repository at "
              + where
              + ", or the credential cannot read it. Check the URL and the credential.",
          e);
    }
    if (isRefused(message)) {
      return new RemoteException(
          "The credential was refused by "
              + where
              + ": it is missing, wrong or expired, or cannot read this repository. Enter a new"
              + " one.",
          e);
    }
    if (message.contains("edirect")) {
      return new RemoteException(
          where + " answers with a redirect, which is not followed. Set the final URL: " + message,
          e);
    }
    if (e instanceof TransportException || e instanceof NotSupportedException) {
      return new RemoteException(
          where + " cannot be fetched: " + message + ". It is tried again later.", e);
    }
    return new RemoteException("The repository cannot be read: " + message + ".", e);
  }

  private static boolean isRefused(String message) {
    return message.contains("not authorized")
        || message.contains("Authentication is required")
        || message.contains("not permitted")
        || message.contains("authentication methods available")
        || message.contains("Cannot log in")
        || message.contains("403");
  }
}
