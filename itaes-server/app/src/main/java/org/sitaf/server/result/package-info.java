/** Accepted results: storage, statistics and exports. */
@NullMarked
package org.sitaf.server.result;

import org.jspecify.annotations.NullMarked;
