/** Interfaces for a person to read: files as a person names them, descriptions as lines of text. */
@NullMarked
package org.sitaf.cli.describe;

import org.jspecify.annotations.NullMarked;
