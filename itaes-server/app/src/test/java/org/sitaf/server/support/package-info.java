/** Test support: clients of the REST interface, a fake agent, and an example activity. */
@NullMarked
package org.sitaf.server.support;

import org.jspecify.annotations.NullMarked;
