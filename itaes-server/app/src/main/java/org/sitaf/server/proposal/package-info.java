/** Proposals of new activities, which are not stored. */
@NullMarked
package org.sitaf.server.proposal;

import org.jspecify.annotations.NullMarked;
