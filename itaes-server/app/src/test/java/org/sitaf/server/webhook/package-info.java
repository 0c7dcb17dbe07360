/** Tests of webhooks. */
@NullMarked
package org.sitaf.server.webhook;

import org.jspecify.annotations.NullMarked;
