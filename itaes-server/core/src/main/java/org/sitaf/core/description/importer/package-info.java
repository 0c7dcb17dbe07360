/** The way in: interface files of every kind that SITAF reads. */
@NullMarked
package org.sitaf.core.description.importer;

import org.jspecify.annotations.NullMarked;
