/** Documents of results: the test result descriptor, the lines of test applications, JUnit XML. */
@NullMarked
package org.sitaf.core.verdict.document;

import org.jspecify.annotations.NullMarked;
