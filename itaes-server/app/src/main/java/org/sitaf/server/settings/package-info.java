/** Settings, validated at startup. */
@NullMarked
package org.sitaf.server.settings;

import org.jspecify.annotations.NullMarked;
