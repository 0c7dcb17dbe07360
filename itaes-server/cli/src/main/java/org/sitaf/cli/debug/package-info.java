/**
 * Debugs the component in one case on this machine, and shows the scene of the case in a browser.
 */
@NullMarked
package org.sitaf.cli.debug;

import org.jspecify.annotations.NullMarked;
