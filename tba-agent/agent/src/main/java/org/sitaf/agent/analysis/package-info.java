/** Analyses of a build that has a result: further executions of its test application. */
@NullMarked
package org.sitaf.agent.analysis;

import org.jspecify.annotations.NullMarked;
