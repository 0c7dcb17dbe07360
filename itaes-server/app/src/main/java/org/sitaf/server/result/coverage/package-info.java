/** Coverage of the component's sources. */
@NullMarked
package org.sitaf.server.result.coverage;

import org.jspecify.annotations.NullMarked;
