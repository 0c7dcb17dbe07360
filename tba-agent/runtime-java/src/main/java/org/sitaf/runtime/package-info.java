/**
 * What a generated test application is made of, and what a component under test sees of its robot.
 */
@NullMarked
package org.sitaf.runtime;

import org.jspecify.annotations.NullMarked;
