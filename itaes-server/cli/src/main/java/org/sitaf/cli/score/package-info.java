/** {@code ./sitaf score}: faults between driver and component, and what the test cases notice. */
@org.jspecify.annotations.NullMarked
package org.sitaf.cli.score;
