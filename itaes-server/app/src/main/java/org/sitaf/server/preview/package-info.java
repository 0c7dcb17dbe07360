/** Previews of test models that are being edited. */
@NullMarked
package org.sitaf.server.preview;

import org.jspecify.annotations.NullMarked;
