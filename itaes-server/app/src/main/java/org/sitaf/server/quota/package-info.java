/** Users' quotas for files, activities, suites and builds. */
@NullMarked
package org.sitaf.server.quota;

import org.jspecify.annotations.NullMarked;
