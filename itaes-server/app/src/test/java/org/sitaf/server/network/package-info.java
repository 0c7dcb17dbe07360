/** Tests of client addresses behind proxies. */
@NullMarked
package org.sitaf.server.network;

import org.jspecify.annotations.NullMarked;
