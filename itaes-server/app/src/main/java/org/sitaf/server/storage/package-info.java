/** Handling of full disks, and permissions of the server's files. */
@NullMarked
package org.sitaf.server.storage;

import org.jspecify.annotations.NullMarked;
