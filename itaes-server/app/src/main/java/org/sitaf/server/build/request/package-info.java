/** What a build asks of the agent that executes it, and of the queue it waits in. */
@NullMarked
package org.sitaf.server.build.request;

import org.jspecify.annotations.NullMarked;
