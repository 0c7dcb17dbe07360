/**
 * Test Data Combinator: covering arrays over dense ints, which know nothing of names, XML or
 * conditions' language.
 */
@NullMarked
package org.sitaf.core.combine;

import org.jspecify.annotations.NullMarked;
