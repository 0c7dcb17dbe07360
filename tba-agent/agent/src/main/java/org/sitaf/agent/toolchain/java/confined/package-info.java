/**
 * What works on users' Java files in processes of its own, inside the sandbox: javac and JaCoCo. It
 * is packed into a jar without the rest of the agent, and only {@link
 * org.sitaf.agent.toolchain.java.confined.Wire} is used on both sides.
 */
@NullMarked
package org.sitaf.agent.toolchain.java.confined;

import org.jspecify.annotations.NullMarked;
