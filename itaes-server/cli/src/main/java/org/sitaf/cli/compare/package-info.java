/** Compares two versions of an activity on this machine. */
@NullMarked
package org.sitaf.cli.compare;

import org.jspecify.annotations.NullMarked;
