/**
 * Test Data Combinator: generates covering arrays over integers. Independent of names, documents
 * and the language of conditions.
 */
@NullMarked
package org.sitaf.core.combine;

import org.jspecify.annotations.NullMarked;
