/** API tokens, with which scripts act for a user. */
@NullMarked
package org.sitaf.server.access.token;

import org.jspecify.annotations.NullMarked;
