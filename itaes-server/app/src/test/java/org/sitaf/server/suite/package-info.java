@NullMarked
package org.sitaf.server.suite;

import org.jspecify.annotations.NullMarked;
