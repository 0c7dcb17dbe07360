/** What people's models make the server compute: few at once, and each for a limited time. */
@NullMarked
package org.sitaf.server.computation;

import org.jspecify.annotations.NullMarked;
