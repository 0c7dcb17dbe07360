/** Base of the generated test stubs: answers, errors and delays of calls, and their record. */
@NullMarked
package org.sitaf.runtime.stub;

import org.jspecify.annotations.NullMarked;
