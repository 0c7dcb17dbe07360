/** The diagram of a sequence's abstract states. */
@NullMarked
package org.sitaf.server.result.states;

import org.jspecify.annotations.NullMarked;
