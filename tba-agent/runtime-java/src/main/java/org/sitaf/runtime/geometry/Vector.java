package org.sitaf.runtime.geometry;

/** A vector; the method that returns it documents the unit. */
public record Vector(double x, double y, double z) {}
