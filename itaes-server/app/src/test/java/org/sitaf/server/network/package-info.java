/** Whose requests they are. */
@NullMarked
package org.sitaf.server.network;

import org.jspecify.annotations.NullMarked;
