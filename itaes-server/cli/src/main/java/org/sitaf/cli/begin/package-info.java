/**
 * The command that begins an activity: questions on a terminal, files on disk, worlds of robots.
 */
@NullMarked
package org.sitaf.cli.begin;

import org.jspecify.annotations.NullMarked;
