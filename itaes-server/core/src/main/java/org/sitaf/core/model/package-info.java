/** Test models: test elements, specifications and conditions, and their validation. */
@NullMarked
package org.sitaf.core.model;

import org.jspecify.annotations.NullMarked;
