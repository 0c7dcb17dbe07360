/** Types shared by the importers: input files, declared types and results. */
@NullMarked
package org.sitaf.core.description.source;

import org.jspecify.annotations.NullMarked;
