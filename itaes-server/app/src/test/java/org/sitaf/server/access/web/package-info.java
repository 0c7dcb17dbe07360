/** What the server refuses before any controller is reached. */
@NullMarked
package org.sitaf.server.access.web;

import org.jspecify.annotations.NullMarked;
