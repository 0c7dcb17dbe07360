/** What can be tested of the dialogue with agents without a server. */
@NullMarked
package org.sitaf.server.build.agent;

import org.jspecify.annotations.NullMarked;
