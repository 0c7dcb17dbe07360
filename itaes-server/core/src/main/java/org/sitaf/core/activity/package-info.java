/**
 * One component under test as files: its profile, interfaces, world and models, read and verified
 * together.
 */
@NullMarked
package org.sitaf.core.activity;

import org.jspecify.annotations.NullMarked;
