/** Reads messages, services and actions of ROS 2. */
@NullMarked
package org.sitaf.core.description.ros;

import org.jspecify.annotations.NullMarked;
