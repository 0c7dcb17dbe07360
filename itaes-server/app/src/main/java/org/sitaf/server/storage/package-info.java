/** The server's own disks, and what happens when they run full. */
@NullMarked
package org.sitaf.server.storage;

import org.jspecify.annotations.NullMarked;
