/** Interface Test Case Generator (ITCG): generates test suites from test models. */
@NullMarked
package org.sitaf.core.suite;

import org.jspecify.annotations.NullMarked;
