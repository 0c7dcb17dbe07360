/** Tests of build requests. */
@NullMarked
package org.sitaf.server.build.request;

import org.jspecify.annotations.NullMarked;
