/** Explanations and scores of builds, as they are stored and as the REST interface shows them. */
@NullMarked
package org.sitaf.server.build.analysis;

import org.jspecify.annotations.NullMarked;
