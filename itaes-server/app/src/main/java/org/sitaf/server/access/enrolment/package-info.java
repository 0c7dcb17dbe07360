/** How agents are let in: an enrolment once, a key of their own afterwards. */
@NullMarked
package org.sitaf.server.access.enrolment;

import org.jspecify.annotations.NullMarked;
