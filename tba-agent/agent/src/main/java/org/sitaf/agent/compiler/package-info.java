/** Test Application Compiler (TAC): sources of a test application to something that starts. */
@NullMarked
package org.sitaf.agent.compiler;

import org.jspecify.annotations.NullMarked;
