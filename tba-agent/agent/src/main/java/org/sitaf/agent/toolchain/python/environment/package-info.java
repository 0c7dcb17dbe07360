/** Virtual environments with the packages of components, which come from an untrusted index. */
@NullMarked
package org.sitaf.agent.toolchain.python.environment;

import org.jspecify.annotations.NullMarked;
