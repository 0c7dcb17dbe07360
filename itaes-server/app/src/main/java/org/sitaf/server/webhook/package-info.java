/** Tells other systems, by HTTP, that a build is over. */
@NullMarked
package org.sitaf.server.webhook;

import org.jspecify.annotations.NullMarked;
