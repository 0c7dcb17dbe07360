/** Signals of cases over time, which the portal plots. */
@NullMarked
package org.sitaf.server.build.signal;

import org.jspecify.annotations.NullMarked;
