/** Sessions: sign in and sign out. */
@NullMarked
package org.sitaf.server.access.session;

import org.jspecify.annotations.NullMarked;
