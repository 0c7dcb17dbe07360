/** Files of users and of this installation. */
@NullMarked
package org.sitaf.cli.file;

import org.jspecify.annotations.NullMarked;
