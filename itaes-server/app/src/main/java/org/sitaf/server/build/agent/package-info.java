/** Build agents: their streams, what is dispatched to them, and what they report. */
@NullMarked
package org.sitaf.server.build.agent;

import org.jspecify.annotations.NullMarked;
