@NullMarked
package org.sitaf.server.build;

import org.jspecify.annotations.NullMarked;
