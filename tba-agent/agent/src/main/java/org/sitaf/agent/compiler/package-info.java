/** Test Application Compiler (TAC): compiles the sources of a test application. */
@NullMarked
package org.sitaf.agent.compiler;

import org.jspecify.annotations.NullMarked;
