package org.sitaf.runtime.geometry;

/** A rotation as a unit quaternion. */
public record Quaternion(double x, double y, double z, double w) {}
