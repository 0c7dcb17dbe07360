package org.sitaf.server.git.source;

/** The kind of a forge, which decides its HTTP interface. */
public enum Forge {
  NONE,
  GITHUB,
  GITLAB,
  /** Gitea or Forgejo. */
  GITEA
}
