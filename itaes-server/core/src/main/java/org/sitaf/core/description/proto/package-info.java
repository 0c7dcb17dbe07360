/** Reads protobuf services. */
@NullMarked
package org.sitaf.core.description.proto;

import org.jspecify.annotations.NullMarked;
