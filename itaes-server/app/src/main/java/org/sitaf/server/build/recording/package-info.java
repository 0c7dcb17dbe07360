/** Recordings of the simulation as binary glTF, for replay in the portal. */
@NullMarked
package org.sitaf.server.build.recording;

import org.jspecify.annotations.NullMarked;
