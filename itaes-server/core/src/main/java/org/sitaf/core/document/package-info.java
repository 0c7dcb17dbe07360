/**
 * Untrusted XML and YAML, read safely and with line numbers, and written so that the same input
 * gives the same bytes.
 */
@NullMarked
package org.sitaf.core.document;

import org.jspecify.annotations.NullMarked;
