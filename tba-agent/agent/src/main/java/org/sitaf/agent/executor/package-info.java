/**
 * Test Application Executor (TAE): runs a test application in processes of its own and brings back
 * a result for every case.
 */
@NullMarked
package org.sitaf.agent.executor;

import org.jspecify.annotations.NullMarked;
