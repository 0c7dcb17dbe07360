/** Pull and merge requests: what forges report of them, and which of their heads are built. */
@NullMarked
package org.sitaf.server.git.request;

import org.jspecify.annotations.NullMarked;
