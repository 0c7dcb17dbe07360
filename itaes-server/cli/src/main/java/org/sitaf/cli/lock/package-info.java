/** The command {@code lock}: keeps the packages of an activity at exact releases. */
@NullMarked
package org.sitaf.cli.lock;

import org.jspecify.annotations.NullMarked;
