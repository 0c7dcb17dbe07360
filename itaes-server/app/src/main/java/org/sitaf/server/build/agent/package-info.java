/** Build agents: their streams, the dispatcher, and the gRPC service for their reports. */
@NullMarked
package org.sitaf.server.build.agent;

import org.jspecify.annotations.NullMarked;
