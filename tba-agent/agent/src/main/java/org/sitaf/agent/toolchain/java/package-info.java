/** Java: javac within the agent, no code of the user at compile time, a JVM for each process. */
@NullMarked
package org.sitaf.agent.toolchain.java;

import org.jspecify.annotations.NullMarked;
