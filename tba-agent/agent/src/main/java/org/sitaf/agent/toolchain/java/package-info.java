/**
 * The Java toolchain: javac in the sandbox without running code of users, and a JVM per process.
 */
@NullMarked
package org.sitaf.agent.toolchain.java;

import org.jspecify.annotations.NullMarked;
