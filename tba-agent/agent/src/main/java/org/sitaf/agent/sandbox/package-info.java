/** Starts processes of other people's code with no more than they need. */
@NullMarked
package org.sitaf.agent.sandbox;

import org.jspecify.annotations.NullMarked;
