/** What the driver does to a component beside the call: its life, its periods, its data ports. */
@NullMarked
package org.sitaf.runtime.component;

import org.jspecify.annotations.NullMarked;
