/** Generates test applications in Python: typed views decide, templates print. */
@NullMarked
package org.sitaf.core.harness.python;

import org.jspecify.annotations.NullMarked;
