/** The test build agent (TBA) as a program: its command line and its settings. */
@NullMarked
package org.sitaf.agent;

import org.jspecify.annotations.NullMarked;
