/** Tests of the agent protocol without a server. */
@NullMarked
package org.sitaf.server.build.agent;

import org.jspecify.annotations.NullMarked;
