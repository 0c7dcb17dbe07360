/** Proposes the activity of a ROS 2 package that exists. */
@NullMarked
package org.sitaf.core.beginning.node;

import org.jspecify.annotations.NullMarked;
