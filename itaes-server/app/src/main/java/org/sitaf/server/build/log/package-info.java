/** Logs of builds: files, with their lengths in the database. */
@NullMarked
package org.sitaf.server.build.log;

import org.jspecify.annotations.NullMarked;
