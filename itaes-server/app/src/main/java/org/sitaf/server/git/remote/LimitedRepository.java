package org.sitaf.server.git.remote;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.eclipse.jgit.internal.storage.file.FileRepository;
import org.eclipse.jgit.lib.ObjectInserter;
import org.eclipse.jgit.lib.StoredConfig;
import org.eclipse.jgit.transport.PackParser;
import org.jspecify.annotations.Nullable;

/** The server's copy of a repository, which receives objects within limits. */
final class LimitedRepository extends FileRepository {
  private @Nullable FetchLimits limits;

  private LimitedRepository(Path folder) throws IOException {
    super(folder.toFile());
  }

  /** Opens the copy, and creates it if necessary. */
  static LimitedRepository open(Path folder) throws IOException {
    boolean exists = Files.exists(folder.resolve("HEAD"));
    Files.createDirectories(folder);
    LimitedRepository repository = new LimitedRepository(folder);
    if (!exists) {
      repository.create(true);
      StoredConfig config = repository.getConfig();
      // A redirect could lead to a host that is not allowed, with the credential.
      config.setString("http", null, "followRedirects", "false");
      config.setBoolean("gc", null, "autoDetach", false);
      config.save();
    }
    return repository;
  }

  void limit(FetchLimits newLimits) {
    limits = newLimits;
  }

  @Override
  public ObjectInserter newObjectInserter() {
    ObjectInserter original = super.newObjectInserter();
    FetchLimits current = limits;
    return current == null ? original : new Limited(original, current);
  }

  private static final class Limited extends ObjectInserter.Filter {
    private final ObjectInserter original;
    private final FetchLimits limits;

    Limited(ObjectInserter original, FetchLimits limits) {
      this.original = original;
      this.limits = limits;
    }

    @Override
    protected ObjectInserter delegate() {
      return original;
    }

    @Override
    public PackParser newPackParser(InputStream in) throws IOException {
      PackParser parser = super.newPackParser(limits.objects(in));
      parser.setMaxObjectSizeLimit(limits.maxObject());
      return parser;
    }
  }
}
