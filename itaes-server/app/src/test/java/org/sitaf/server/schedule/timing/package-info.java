/** Tests of fire times. */
@NullMarked
package org.sitaf.server.schedule.timing;

import org.jspecify.annotations.NullMarked;
