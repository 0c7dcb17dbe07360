/** The history of a case: what it did in all commits of a branch, or in all builds of its model. */
@NullMarked
package org.sitaf.server.history;

import org.jspecify.annotations.NullMarked;
