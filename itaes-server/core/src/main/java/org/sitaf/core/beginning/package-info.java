/**
 * Proposes the files of a new activity from the interface of a component: test models whose ranges
 * follow from names, units and types, the skeleton of a component, and {@code activity.yaml}.
 */
@NullMarked
package org.sitaf.core.beginning;

import org.jspecify.annotations.NullMarked;
