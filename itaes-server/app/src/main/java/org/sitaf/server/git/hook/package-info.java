/** Messages of forges: a push is fetched at once, and a request is listed or built. */
@NullMarked
package org.sitaf.server.git.hook;

import org.jspecify.annotations.NullMarked;
