/**
 * Fault campaigns: every fault of the devices of a world, alone and in pairs, and what the
 * component does.
 */
@NullMarked
package org.sitaf.core.campaign;

import org.jspecify.annotations.NullMarked;
