/** Plans test applications in Java: names, types, literals and calls. */
@NullMarked
package org.sitaf.core.harness.java.plan;

import org.jspecify.annotations.NullMarked;
