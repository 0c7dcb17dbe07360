/** The component's standard streams, case by case. */
@NullMarked
package org.sitaf.runtime.output;

import org.jspecify.annotations.NullMarked;
