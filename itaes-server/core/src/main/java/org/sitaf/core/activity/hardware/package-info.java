/** The devices of an activity that are not simulated: real ones, recordings, and shadows. */
@NullMarked
package org.sitaf.core.activity.hardware;

import org.jspecify.annotations.NullMarked;
