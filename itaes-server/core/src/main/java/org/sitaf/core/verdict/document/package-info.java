/** Results as documents: the test result descriptor, the lines it is made of, and JUnit's. */
@NullMarked
package org.sitaf.core.verdict.document;

import org.jspecify.annotations.NullMarked;
