/** Language-independent plans of test applications. */
@NullMarked
package org.sitaf.core.harness.plan;

import org.jspecify.annotations.NullMarked;
