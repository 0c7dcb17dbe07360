/** What a reader gets of an explanation: sentences, and bundles that can be replayed. */
@NullMarked
package org.sitaf.core.explain.report;

import org.jspecify.annotations.NullMarked;
