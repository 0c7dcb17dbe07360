@NullMarked
package org.sitaf.server.build.log;

import org.jspecify.annotations.NullMarked;
