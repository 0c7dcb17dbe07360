/** Test suites as XML documents and as CSV tables. */
@NullMarked
package org.sitaf.core.suite.document;

import org.jspecify.annotations.NullMarked;
