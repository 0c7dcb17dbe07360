/** Options of build requests, and the requirements for agents. */
@NullMarked
package org.sitaf.server.build.request;

import org.jspecify.annotations.NullMarked;
