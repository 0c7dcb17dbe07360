/** Reads interfaces in OMG IDL. */
@NullMarked
package org.sitaf.core.description.idl;

import org.jspecify.annotations.NullMarked;
