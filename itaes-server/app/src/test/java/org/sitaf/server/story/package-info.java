/** End-to-end tests of the server through its REST and gRPC interfaces. */
@NullMarked
package org.sitaf.server.story;

import org.jspecify.annotations.NullMarked;
