/** Authentication and authorization: roles, callers and their settings. */
@NullMarked
package org.sitaf.server.access;

import org.jspecify.annotations.NullMarked;
