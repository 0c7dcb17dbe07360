/**
 * What a generated test stub is built on: answers, errors and delays of calls, and their record.
 */
@NullMarked
package org.sitaf.runtime.stub;

import org.jspecify.annotations.NullMarked;
