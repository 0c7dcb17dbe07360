/** Tests of disk space and the database file. */
@NullMarked
package org.sitaf.server.storage;

import org.jspecify.annotations.NullMarked;
