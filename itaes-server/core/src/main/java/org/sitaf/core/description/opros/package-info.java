/** Reads interfaces and component profiles of the OPRoS platform (paper, Fig. 3). */
@NullMarked
package org.sitaf.core.description.opros;

import org.jspecify.annotations.NullMarked;
