package org.sitaf.runtime.geometry;

/** A rotation, of unit length. */
public record Quaternion(double x, double y, double z, double w) {}
