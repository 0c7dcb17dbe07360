/** Life cycle, periods, nonblocking calls and data ports of a component. */
@NullMarked
package org.sitaf.runtime.component;

import org.jspecify.annotations.NullMarked;
