/** How much of the server a person may use: files, activities, suites, builds. */
@NullMarked
package org.sitaf.server.quota;

import org.jspecify.annotations.NullMarked;
