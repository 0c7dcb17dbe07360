/** Standard output of the component, separated by case. */
@NullMarked
package org.sitaf.runtime.output;

import org.jspecify.annotations.NullMarked;
