/**
 * What the importers of interface files share: the files, the table of named types, what was found.
 */
@NullMarked
package org.sitaf.core.description.source;

import org.jspecify.annotations.NullMarked;
