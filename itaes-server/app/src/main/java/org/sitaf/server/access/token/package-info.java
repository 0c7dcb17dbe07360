/** Tokens with which scripts do what a person may. */
@NullMarked
package org.sitaf.server.access.token;

import org.jspecify.annotations.NullMarked;
