/**
 * What a test application in Java will hold, decided before anything is printed: names, types,
 * literals, calls.
 */
@NullMarked
package org.sitaf.core.harness.java.plan;

import org.jspecify.annotations.NullMarked;
