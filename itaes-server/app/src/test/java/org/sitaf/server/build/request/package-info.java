/** How builds are asked for. */
@NullMarked
package org.sitaf.server.build.request;

import org.jspecify.annotations.NullMarked;
