/** Client addresses and trusted proxies. */
@NullMarked
package org.sitaf.server.network;

import org.jspecify.annotations.NullMarked;
