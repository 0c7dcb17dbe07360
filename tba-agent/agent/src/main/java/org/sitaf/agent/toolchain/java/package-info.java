/**
 * Java: javac in a process of the sandbox, no code of the user at compile time, a JVM for each
 * process.
 */
@NullMarked
package org.sitaf.agent.toolchain.java;

import org.jspecify.annotations.NullMarked;
