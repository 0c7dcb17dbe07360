/** What a test model would give, worked out while it is being written; nothing is stored. */
@NullMarked
package org.sitaf.server.preview;

import org.jspecify.annotations.NullMarked;
