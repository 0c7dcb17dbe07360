/** What agents brought back: accepted results, their rows, and exports. */
@NullMarked
package org.sitaf.server.result;

import org.jspecify.annotations.NullMarked;
