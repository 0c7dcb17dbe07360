/** ROS 2 nodes as components: their topics, parameters and message types. */
@NullMarked
package org.sitaf.core.activity.ros;

import org.jspecify.annotations.NullMarked;
