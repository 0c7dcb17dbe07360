/** Shared fixtures of the agent's tests, such as a small activity. */
@NullMarked
package org.sitaf.agent.testing;

import org.jspecify.annotations.NullMarked;
