/**
 * The preprocessor of OMG IDL: includes, macros and conditional sections, as in C++ (ISO/IEC 14882,
 * clause "Preprocessing directives", which OMG IDL 4.2, 7.3 refers to). All work is bounded.
 */
@NullMarked
package org.sitaf.core.description.idl.preprocessor;

import org.jspecify.annotations.NullMarked;
