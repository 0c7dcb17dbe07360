/** An agent's files: results that wait for upload, and caches. */
@NullMarked
package org.sitaf.agent.spool;

import org.jspecify.annotations.NullMarked;
