/** What the server does beside its requests, now and then. */
@NullMarked
package org.sitaf.server.timer;

import org.jspecify.annotations.NullMarked;
