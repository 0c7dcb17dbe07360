package org.sitaf.core.git;

import java.io.IOException;
import org.eclipse.jgit.errors.ConfigInvalidException;
import org.eclipse.jgit.lib.Config;
import org.eclipse.jgit.storage.file.FileBasedConfig;
import org.eclipse.jgit.util.FS;
import org.eclipse.jgit.util.SystemReader;

/**
 * Lets Git repositories be read without the configuration of the machine or the user, and without a
 * program that finds it.
 */
public final class NoUserConfiguration extends SystemReader.Delegate {
  private NoUserConfiguration(SystemReader original) {
    super(original);
  }

  /** Makes it the configuration of this process. */
  public static void install() {
    SystemReader current = SystemReader.getInstance();
    if (!(current instanceof NoUserConfiguration)) {
      SystemReader.setInstance(new NoUserConfiguration(current));
    }
  }

  @Override
  public FileBasedConfig openSystemConfig(Config parent, FS fs) {
    return new Empty(parent, fs);
  }

  @Override
  public FileBasedConfig openUserConfig(Config parent, FS fs) {
    return new Empty(parent, fs);
  }

  @Override
  public FileBasedConfig openJGitConfig(Config parent, FS fs) {
    return new Empty(parent, fs);
  }

  /** A configuration without a file. */
  private static final class Empty extends FileBasedConfig {
    Empty(Config parent, FS fs) {
      super(parent, null, fs);
    }

    @Override
    public void load() throws IOException, ConfigInvalidException {
      // There is no file.
    }

    @Override
    public void save() {
      // Measurements of the file system are not kept.
    }

    @Override
    public boolean isOutdated() {
      return false;
    }
  }
}
