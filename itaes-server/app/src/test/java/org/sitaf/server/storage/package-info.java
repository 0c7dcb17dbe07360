/** What other systems are told, and where the server does not go. */
@NullMarked
package org.sitaf.server.storage;

import org.jspecify.annotations.NullMarked;
