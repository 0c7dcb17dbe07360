/** Generates test applications in Java: typed views decide, templates print. */
@NullMarked
package org.sitaf.core.harness.java;

import org.jspecify.annotations.NullMarked;
