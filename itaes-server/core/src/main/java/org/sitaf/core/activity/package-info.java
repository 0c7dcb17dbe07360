/**
 * Test activities: the profile, interfaces, world and models of one component under test, read and
 * verified together.
 */
@NullMarked
package org.sitaf.core.activity;

import org.jspecify.annotations.NullMarked;
