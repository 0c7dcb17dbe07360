package org.sitaf.runtime.suite;

/**
 * A new value of an output data port.
 *
 * @param nanos simulation time
 */
public record PortChange(long nanos, String literal) {}
