/** Security configuration: access rules, token authentication and checks at startup. */
@NullMarked
package org.sitaf.server.access.web;

import org.jspecify.annotations.NullMarked;
