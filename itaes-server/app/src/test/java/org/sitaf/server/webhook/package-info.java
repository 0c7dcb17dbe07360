/** What other systems are told, and where the server does not go. */
@NullMarked
package org.sitaf.server.webhook;

import org.jspecify.annotations.NullMarked;
