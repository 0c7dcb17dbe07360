/** One build, from a test application to its outcome: the stages of a test build agent. */
@NullMarked
package org.sitaf.agent.build;

import org.jspecify.annotations.NullMarked;
