@NullMarked
package org.sitaf.server.computation;

import org.jspecify.annotations.NullMarked;
