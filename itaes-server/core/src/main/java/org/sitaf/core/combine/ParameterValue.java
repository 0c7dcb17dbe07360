package org.sitaf.core.combine;

/**
 * A value of a parameter.
 *
 * @param value from 0
 */
public record ParameterValue(int parameter, int value) {}
