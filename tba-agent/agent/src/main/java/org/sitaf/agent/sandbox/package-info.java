/** Runs processes of untrusted code with the least privileges that they need. */
@NullMarked
package org.sitaf.agent.sandbox;

import org.jspecify.annotations.NullMarked;
