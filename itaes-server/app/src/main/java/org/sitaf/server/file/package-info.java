/** Content-addressed files in the database. */
@NullMarked
package org.sitaf.server.file;

import org.jspecify.annotations.NullMarked;
