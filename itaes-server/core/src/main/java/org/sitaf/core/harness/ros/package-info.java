/** Generates test applications of ROS 2 nodes: data that the runtime interprets. */
@NullMarked
package org.sitaf.core.harness.ros;

import org.jspecify.annotations.NullMarked;
