/**
 * Test suites: generated from a model, kept as documents, edited, and made into test applications.
 */
@NullMarked
package org.sitaf.server.suite;

import org.jspecify.annotations.NullMarked;
