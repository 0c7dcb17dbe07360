/** What an operator may set, validated at start. */
@NullMarked
package org.sitaf.server.settings;

import org.jspecify.annotations.NullMarked;
