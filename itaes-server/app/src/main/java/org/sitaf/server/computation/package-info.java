/** Computations for users' models, with limits for their number and their time. */
@NullMarked
package org.sitaf.server.computation;

import org.jspecify.annotations.NullMarked;
