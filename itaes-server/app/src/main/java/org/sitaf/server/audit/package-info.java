/** Who changed what, and who tried. */
@NullMarked
package org.sitaf.server.audit;

import org.jspecify.annotations.NullMarked;
