/**
 * Lays out generated sources: templates print each statement and each paragraph on one line, and a
 * layout of the language breaks the lines that are too long.
 */
@NullMarked
package org.sitaf.core.harness.layout;

import org.jspecify.annotations.NullMarked;
