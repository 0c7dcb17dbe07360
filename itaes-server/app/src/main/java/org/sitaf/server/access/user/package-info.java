/** Users and their passwords. */
@NullMarked
package org.sitaf.server.access.user;

import org.jspecify.annotations.NullMarked;
