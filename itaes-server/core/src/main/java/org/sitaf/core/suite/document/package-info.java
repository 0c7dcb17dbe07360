/** Suites as documents: the test suite data, and the table that people edit. */
@NullMarked
package org.sitaf.core.suite.document;

import org.jspecify.annotations.NullMarked;
