/** Interface Test Application Generator (ITAG): generates the sources of a test application. */
@NullMarked
package org.sitaf.core.harness;

import org.jspecify.annotations.NullMarked;
