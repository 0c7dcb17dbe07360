/** Messages of forges: a push is fetched at once. */
@NullMarked
package org.sitaf.server.git.hook;

import org.jspecify.annotations.NullMarked;
