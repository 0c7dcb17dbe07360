/** Fetches from Git repositories that are untrusted, within limits. */
@NullMarked
package org.sitaf.server.git.remote;

import org.jspecify.annotations.NullMarked;
