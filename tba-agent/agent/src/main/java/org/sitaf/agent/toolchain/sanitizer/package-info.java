/** Settings and reports of AddressSanitizer, UBSan and ThreadSanitizer. */
@NullMarked
package org.sitaf.agent.toolchain.sanitizer;

import org.jspecify.annotations.NullMarked;
