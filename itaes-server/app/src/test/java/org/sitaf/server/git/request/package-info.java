@NullMarked
package org.sitaf.server.git.request;

import org.jspecify.annotations.NullMarked;
