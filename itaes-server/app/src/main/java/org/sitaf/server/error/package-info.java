/** Errors that the server reports to its callers, as opposed to its own failures. */
@NullMarked
package org.sitaf.server.error;

import org.jspecify.annotations.NullMarked;
