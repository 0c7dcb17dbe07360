/** What a build reached of the component's sources, file by file. */
@NullMarked
package org.sitaf.server.result.coverage;

import org.jspecify.annotations.NullMarked;
