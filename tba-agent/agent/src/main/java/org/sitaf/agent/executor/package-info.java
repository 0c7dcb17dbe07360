/**
 * Test Application Executor (TAE): runs a test application in separate processes and returns a
 * result for every case.
 */
@NullMarked
package org.sitaf.agent.executor;

import org.jspecify.annotations.NullMarked;
