/** Automatic Test Build Manager: build requests, their attempts and leases, and the queue. */
@NullMarked
package org.sitaf.server.build;

import org.jspecify.annotations.NullMarked;
