/** Why the server does not do what it was asked for, told apart from failures of its own. */
@NullMarked
package org.sitaf.server.refusal;

import org.jspecify.annotations.NullMarked;
