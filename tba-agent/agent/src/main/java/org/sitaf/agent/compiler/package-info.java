/**
 * Test Application Compiler (TAC): sources of a test application to classes, errors to diagnostics.
 */
@NullMarked
package org.sitaf.agent.compiler;

import org.jspecify.annotations.NullMarked;
