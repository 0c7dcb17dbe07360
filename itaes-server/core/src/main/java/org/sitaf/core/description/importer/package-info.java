/** Selects the importer for an interface file. */
@NullMarked
package org.sitaf.core.description.importer;

import org.jspecify.annotations.NullMarked;
