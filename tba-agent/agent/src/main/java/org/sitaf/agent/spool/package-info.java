/**
 * What an agent keeps on disk: results that it still owes its server, and what it need not fetch or
 * make again.
 */
@NullMarked
package org.sitaf.agent.spool;

import org.jspecify.annotations.NullMarked;
