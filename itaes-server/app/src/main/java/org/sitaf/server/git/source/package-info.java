/** Where the files of activities come from: repositories, branches, folders, credentials. */
@NullMarked
package org.sitaf.server.git.source;

import org.jspecify.annotations.NullMarked;
