/** What the tests of several packages need: a small activity, and a server at the rim. */
@NullMarked
package org.sitaf.agent.testing;

import org.jspecify.annotations.NullMarked;
