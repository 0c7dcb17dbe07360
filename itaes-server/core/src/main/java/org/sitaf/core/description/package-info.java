/**
 * The interfaces that a component provides and requires, and the parameters and observations of its
 * world.
 */
@NullMarked
package org.sitaf.core.description;

import org.jspecify.annotations.NullMarked;
