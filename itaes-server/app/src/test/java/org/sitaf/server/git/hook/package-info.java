@NullMarked
package org.sitaf.server.git.hook;

import org.jspecify.annotations.NullMarked;
