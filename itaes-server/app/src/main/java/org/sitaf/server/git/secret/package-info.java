/** Encrypts credentials with a key that lies outside of the database. */
@NullMarked
package org.sitaf.server.git.secret;

import org.jspecify.annotations.NullMarked;
