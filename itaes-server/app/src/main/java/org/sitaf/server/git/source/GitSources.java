package org.sitaf.server.git.source;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.time.Clock;
import java.time.temporal.ChronoUnit;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import org.eclipse.jgit.transport.RefSpec;
import org.jspecify.annotations.Nullable;
import org.sitaf.core.activity.FileTree;
import org.sitaf.server.access.Secret;
import org.sitaf.server.activity.ActivityDeletion;
import org.sitaf.server.activity.ActivityEdit;
import org.sitaf.server.activity.StoredActivities;
import org.sitaf.server.error.RequestException;
import org.sitaf.server.git.GitSettings;
import org.sitaf.server.git.remote.Credential;
import org.sitaf.server.git.remote.GitAddress;
import org.sitaf.server.git.remote.History;
import org.sitaf.server.git.remote.Remote;
import org.sitaf.server.git.remote.RemoteException;
import org.sitaf.server.git.secret.SecretBox;
import org.sitaf.server.settings.SitafSettings;
import org.sitaf.server.storage.DiskSpace;
import org.sitaf.server.web.Requests;
import org.springframework.context.ApplicationEventPublisher;
import org.springframework.context.event.EventListener;
import org.springframework.stereotype.Service;
import org.springframework.util.FileSystemUtils;

/** Creates and changes Git sources, and fetches them. */
@Service
public class GitSources {
  private final SourceRows rows;
  private final Remote remote;
  private final SecretBox secrets;
  private final StoredActivities activities;
  private final GitSettings settings;
  private final Path copies;
  private final DiskSpace disk;
  private final ApplicationEventPublisher events;
  private final Clock clock;

  GitSources(
      SourceRows rows,
      Remote remote,
      SecretBox secrets,
      StoredActivities activities,
      GitSettings settings,
      SitafSettings server,
      DiskSpace disk,
      ApplicationEventPublisher events,
      Clock clock) {
    this.rows = rows;
    this.remote = remote;
    this.secrets = secrets;
    this.activities = activities;
    this.settings = settings;
    this.copies = server.dataDirectory().toAbsolutePath().resolve("git");
    this.disk = disk;
    this.events = events;
    this.clock = clock;
  }

  /** Folder of the server's copy of a repository. */
  public Path copy(String sourceId) {
    return copies.resolve(sourceId);
  }

  /** The source of an activity that has one. */
  public Optional<GitSource> find(String activityId) {
    return rows.ofActivity(activityId);
  }

  /**
   * The source of an activity.
   *
   * @throws RequestException if it has none
   */
  public GitSource require(String activityId) {
    return rows.ofActivity(activityId)
        .orElseThrow(() -> RequestException.notFound("Git source of activity", activityId));
  }

  /**
   * Creates an activity from a repository, which is fetched now.
   *
   * @return the activity's id
   * @throws RequestException if the repository cannot be fetched
   * @throws org.sitaf.core.diagnostic.InvalidInputException if the folder is no activity
   */
  String createActivity(SourceRequest request) {
    String id = UUID.randomUUID().toString();
    GitAddress address = request.address(settings);
    Credential credential = request.checkedCredential(address, Optional.empty());
    GitSource source = source(id, "", request, address, credential, null, Optional.empty());
    boolean created = false;
    try {
      String hostKey =
          remote.fetch(
              copy(id), new Remote.Source(address, credential, null), List.of(refSpec(source)));
      String activityId = activities.create(files(source));
      rows.insert(source(id, activityId, request, address, credential, hostKey, Optional.empty()));
      created = true;
      events.publishEvent(new SourceChanged(id, source.intervalS()));
      return activityId;
    } catch (RemoteException e) {
      throw RequestException.conflict(e.text());
    } finally {
      if (!created) {
        deleteCopy(id);
      }
    }
  }

  private FileTree files(GitSource source) {
    try (History history = History.open(copy(source.id()))) {
      String head =
          history
              .resolve(source.reference())
              .orElseThrow(() -> RequestException.notFound("branch", source.branch()));
      return history.files(head, source.folder());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Sets the source of an activity. */
  GitSource save(String activityId, SourceRequest request, Requests.Expected expected) {
    activities.name(activityId);
    Optional<GitSource> existing = rows.ofActivity(activityId);
    String id = existing.map(GitSource::id).orElseGet(() -> UUID.randomUUID().toString());
    GitAddress address = request.address(settings);
    // A stored secret is never sent to another host than the one it was entered for.
    Optional<GitSource> sameHost =
        existing.filter(
            old ->
                old.credentialKind() == request.kind()
                    && isSameHost(GitAddress.parse(old.url(), settings), address));
    Credential credential =
        request.checkedCredential(
            address,
            sameHost
                .map(GitSource::encryptedSecret)
                .map(encrypted -> secrets.decrypt(encrypted, id)));
    String hostKey =
        request.forgetsHostKey() ? null : sameHost.map(GitSource::hostKey).orElse(null);
    Optional<String> forgeToken =
        existing
            .filter(old -> isSameForge(old, request.checkedProject(address, settings)))
            .map(GitSource::encryptedForgeSecret)
            .map(encrypted -> secrets.decrypt(encrypted, id));
    GitSource source = source(id, activityId, request, address, credential, hostKey, forgeToken);
    if (existing.isEmpty()) {
      rows.insert(source);
    } else {
      expected.require("Git source", existing.get().version());
      if (!rows.update(source, existing.get().version())) {
        throw RequestException.outdated("Git source", existing.get().version() + 1);
      }
    }
    events.publishEvent(new SourceChanged(id, source.intervalS()));
    return require(activityId);
  }

  private static boolean isSameForge(GitSource old, @Nullable ForgeProject project) {
    return project != null && old.project() != null && old.project().api().equals(project.api());
  }

  private static boolean isSameHost(GitAddress one, GitAddress other) {
    return one.transport() == other.transport() && one.host().equals(other.host());
  }

  private GitSource source(
      String id,
      String activityId,
      SourceRequest request,
      GitAddress address,
      Credential credential,
      @Nullable String hostKey,
      Optional<String> storedForgeToken) {
    ForgeProject project = request.checkedProject(address, settings);
    return new GitSource(
        id,
        activityId,
        address.text(),
        request.checkedBranch(),
        request.checkedFolder(),
        request.kind(),
        request.checkedUser(),
        credential.secret().map(secret -> secrets.encrypt(secret, id)).orElse(null),
        hostKey,
        request.checkedPolicy(),
        request.checkedInterval(settings),
        0,
        clock.instant().truncatedTo(ChronoUnit.MICROS),
        null,
        null,
        null,
        null,
        project,
        request
            .checkedForgeToken(project, credential, storedForgeToken)
            .map(token -> secrets.encrypt(token, id))
            .orElse(null),
        null);
  }

  /**
   * Fetches the branch of a source, and further references.
   *
   * @throws RemoteException with what happened and what to do
   */
  public void fetch(GitSource source, List<RefSpec> further) throws RemoteException {
    try {
      disk.requireForNewWork();
      GitAddress address = GitAddress.parse(source.url(), settings);
      List<RefSpec> references = new ArrayList<>(further);
      references.add(refSpec(source));
      String hostKey =
          remote.fetch(
              copy(source.id()),
              new Remote.Source(address, credential(source), source.hostKey()),
              references);
      rows.fetched(source.id(), hostKey);
    } catch (RequestException e) {
      throw new RemoteException(String.valueOf(e.getMessage()));
    }
  }

  private Credential credential(GitSource source) {
    String encrypted = source.encryptedSecret();
    if (encrypted == null) {
      return new Credential.None();
    }
    String secret = secrets.decrypt(encrypted, source.id());
    return source.credentialKind() == GitSource.CredentialKind.TOKEN
        ? new Credential.Token(source.credentialUser(), secret)
        : new Credential.DeployKey(secret);
  }

  /** The token for the forge's interface. */
  public Optional<String> forgeToken(GitSource source) {
    String encrypted = source.encryptedForgeSecret();
    if (encrypted != null) {
      return Optional.of(secrets.decrypt(encrypted, source.id()));
    }
    return credential(source) instanceof Credential.Token token
        ? Optional.of(token.token())
        : Optional.empty();
  }

  /** Creates the secret with which the forge signs its messages; it is shown only once. */
  String createHookSecret(String activityId) {
    GitSource source = require(activityId);
    String secret = Secret.generate("sitaf-git_");
    rows.hookSecret(source.id(), secrets.encrypt(secret, source.id()));
    return secret;
  }

  /** The secret of the forge's messages; empty if there is no source or no secret. */
  public Optional<String> hookSecret(String activityId) {
    return rows.ofActivity(activityId)
        .flatMap(
            source ->
                Optional.ofNullable(source.encryptedHookSecret())
                    .map(encrypted -> secrets.decrypt(encrypted, source.id())));
  }

  private static RefSpec refSpec(GitSource source) {
    return new RefSpec("+" + source.reference() + ":" + source.reference());
  }

  /** Removes the source; the activity keeps its files and can be edited. */
  void delete(String activityId) {
    GitSource source = require(activityId);
    rows.delete(source.id());
    forget(source);
  }

  private void forget(GitSource source) {
    deleteCopy(source.id());
    events.publishEvent(new SourceDeleted(source.id()));
  }

  private void deleteCopy(String id) {
    try {
      FileSystemUtils.deleteRecursively(copy(id));
    } catch (IOException e) {
      throw new UncheckedIOException("The copy of a repository cannot be deleted: " + copy(id), e);
    }
  }

  @EventListener
  void on(ActivityEdit edit) {
    rows.ofActivity(edit.activityId())
        .ifPresent(
            source -> {
              throw RequestException.conflict(
                  "The files of this activity come from "
                      + source.url()
                      + ", branch "
                      + source.branch()
                      + ". Push the change there, or remove the Git source first.");
            });
  }

  @EventListener
  void on(ActivityDeletion deletion) {
    rows.ofActivity(deletion.activityId()).ifPresent(this::forget);
  }
}
