/** Webhooks: HTTP callbacks when a build ends. */
@NullMarked
package org.sitaf.server.webhook;

import org.jspecify.annotations.NullMarked;
