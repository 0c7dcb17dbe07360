package org.sitaf.runtime.geometry;

/** Three numbers along x, y and z; the unit stands where it is used. */
public record Vector(double x, double y, double z) {}
