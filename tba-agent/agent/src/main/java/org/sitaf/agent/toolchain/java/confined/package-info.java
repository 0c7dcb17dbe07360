/**
 * Programs that process users' Java files inside the sandbox: javac and JaCoCo. They are packaged
 * in a jar without the rest of the agent; only {@link org.sitaf.agent.toolchain.java.confined.Wire}
 * is used by both sides.
 */
@NullMarked
package org.sitaf.agent.toolchain.java.confined;

import org.jspecify.annotations.NullMarked;
