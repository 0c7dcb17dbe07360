/** What varies in a test: test elements, specifications, conditions, and their verification. */
@NullMarked
package org.sitaf.core.model;

import org.jspecify.annotations.NullMarked;
