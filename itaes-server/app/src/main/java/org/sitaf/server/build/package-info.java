/** Automatic Test Build Manager: build requests, their attempts, leases and logs. */
@NullMarked
package org.sitaf.server.build;

import org.jspecify.annotations.NullMarked;
