/** Sequences of calls and events, and the abstract state that they change. */
@NullMarked
package org.sitaf.core.model.sequence;

import org.jspecify.annotations.NullMarked;
