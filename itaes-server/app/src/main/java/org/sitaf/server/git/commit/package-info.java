/** Commits of Git sources: each becomes builds of the activity's models. */
@NullMarked
package org.sitaf.server.git.commit;

import org.jspecify.annotations.NullMarked;
