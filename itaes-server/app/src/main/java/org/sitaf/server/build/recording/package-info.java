/** What moved in the cases of builds: binary glTF, for people to see again. */
@NullMarked
package org.sitaf.server.build.recording;

import org.jspecify.annotations.NullMarked;
