/**
 * What a test application will do, decided in terms that every language shares, before a language
 * spells it.
 */
@NullMarked
package org.sitaf.core.harness.plan;

import org.jspecify.annotations.NullMarked;
