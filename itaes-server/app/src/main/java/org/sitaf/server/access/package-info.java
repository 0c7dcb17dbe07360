/** Who may do what: roles, callers, and the settings of both. */
@NullMarked
package org.sitaf.server.access;

import org.jspecify.annotations.NullMarked;
