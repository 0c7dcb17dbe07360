/** The filter through which every request passes, and what it refuses. */
@NullMarked
package org.sitaf.server.access.web;

import org.jspecify.annotations.NullMarked;
