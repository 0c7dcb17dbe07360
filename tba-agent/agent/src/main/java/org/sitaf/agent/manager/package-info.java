/**
 * Test Build Agent Manager (TBAM): the dialogue with the server; the only package that knows its
 * wire.
 */
@NullMarked
package org.sitaf.agent.manager;

import org.jspecify.annotations.NullMarked;
