/** What the component offers and requires, and what its world can vary and observe. */
@NullMarked
package org.sitaf.core.description;

import org.jspecify.annotations.NullMarked;
