/** Base of the generated test stubs: answers, errors, delays and recorded calls. */
@NullMarked
package org.sitaf.runtime.stub;

import org.jspecify.annotations.NullMarked;
