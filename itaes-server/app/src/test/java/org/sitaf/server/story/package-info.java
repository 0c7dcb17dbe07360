/** What people and agents do with the server, from the outside. */
@NullMarked
package org.sitaf.server.story;

import org.jspecify.annotations.NullMarked;
