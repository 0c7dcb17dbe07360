/** The faults between driver and component: of values, inputs, outputs, exceptions and calls. */
@org.jspecify.annotations.NullMarked
package org.sitaf.core.score.fault;
