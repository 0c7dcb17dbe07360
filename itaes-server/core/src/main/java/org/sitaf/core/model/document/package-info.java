/** Reads test model documents: one reader for each noun of the schema. */
@NullMarked
package org.sitaf.core.model.document;

import org.jspecify.annotations.NullMarked;
