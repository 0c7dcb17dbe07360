/**
 * Faults of virtual devices as parameters of a test: their names, and which device can have them.
 */
@NullMarked
package org.sitaf.core.description.fault;

import org.jspecify.annotations.NullMarked;
