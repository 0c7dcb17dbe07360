/**
 * What tests of the server share: an HTTP client, an agent that speaks the protocol by hand, and an
 * activity.
 */
@NullMarked
package org.sitaf.server.support;

import org.jspecify.annotations.NullMarked;
