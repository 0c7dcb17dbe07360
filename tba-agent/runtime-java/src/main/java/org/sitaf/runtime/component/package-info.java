/** What the driver does with a component besides the call: life cycle, periods, data ports. */
@NullMarked
package org.sitaf.runtime.component;

import org.jspecify.annotations.NullMarked;
