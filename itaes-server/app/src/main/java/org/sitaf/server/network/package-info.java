/** From where requests come: addresses, and the proxies that may speak for others. */
@NullMarked
package org.sitaf.server.network;

import org.jspecify.annotations.NullMarked;
