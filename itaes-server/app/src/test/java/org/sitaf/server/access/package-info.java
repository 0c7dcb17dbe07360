/** Who gets in, and who does not. */
@NullMarked
package org.sitaf.server.access;

import org.jspecify.annotations.NullMarked;
