/** REST interface of builds. */
@NullMarked
package org.sitaf.server.build.rest;

import org.jspecify.annotations.NullMarked;
