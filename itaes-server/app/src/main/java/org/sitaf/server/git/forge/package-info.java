/** Forges (GitHub, GitLab, Gitea): sends statuses of commits until the forge has them. */
@NullMarked
package org.sitaf.server.git.forge;

import org.jspecify.annotations.NullMarked;
