@NullMarked
package org.sitaf.server.git;

import org.jspecify.annotations.NullMarked;
