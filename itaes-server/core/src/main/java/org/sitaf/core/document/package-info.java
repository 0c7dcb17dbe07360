/**
 * Reads untrusted XML and YAML safely and with line numbers. Writing is deterministic: the same
 * input gives the same bytes.
 */
@NullMarked
package org.sitaf.core.document;

import org.jspecify.annotations.NullMarked;
