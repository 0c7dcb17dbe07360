/**
 * What an agent keeps on disk: results that it still owes its server, and files that it need not
 * fetch again.
 */
@NullMarked
package org.sitaf.agent.spool;

import org.jspecify.annotations.NullMarked;
