/** Logs of builds, in chunks in the database. */
@NullMarked
package org.sitaf.server.build.log;

import org.jspecify.annotations.NullMarked;
