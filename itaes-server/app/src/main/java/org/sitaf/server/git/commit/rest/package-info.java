/** REST interface of commits. */
@NullMarked
package org.sitaf.server.git.commit.rest;

import org.jspecify.annotations.NullMarked;
