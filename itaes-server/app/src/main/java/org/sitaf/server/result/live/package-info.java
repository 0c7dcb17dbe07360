/** Cases as they finish, for people who watch a build. */
@NullMarked
package org.sitaf.server.result.live;

import org.jspecify.annotations.NullMarked;
