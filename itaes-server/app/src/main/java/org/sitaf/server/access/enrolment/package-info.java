/** Enrolment of agents: an agent enrols with a token once and uses its own key afterwards. */
@NullMarked
package org.sitaf.server.access.enrolment;

import org.jspecify.annotations.NullMarked;
