/** Activities: a component under test each, with its profile, files, world and models. */
@NullMarked
package org.sitaf.server.activity;

import org.jspecify.annotations.NullMarked;
