/** Activities from Git: settings; the packages below fetch, build commits and report to forges. */
@NullMarked
package org.sitaf.server.git;

import org.jspecify.annotations.NullMarked;
