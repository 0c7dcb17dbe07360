/** Test suites: generation, storage and editing; generation of test applications. */
@NullMarked
package org.sitaf.server.suite;

import org.jspecify.annotations.NullMarked;
