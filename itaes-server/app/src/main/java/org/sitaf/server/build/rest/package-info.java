/** Builds and agents over HTTP. */
@NullMarked
package org.sitaf.server.build.rest;

import org.jspecify.annotations.NullMarked;
