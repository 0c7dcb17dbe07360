/** The audit log. */
@NullMarked
package org.sitaf.server.audit;

import org.jspecify.annotations.NullMarked;
