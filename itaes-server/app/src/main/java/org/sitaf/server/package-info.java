/** The SITAF server. */
@NullMarked
package org.sitaf.server;

import org.jspecify.annotations.NullMarked;
