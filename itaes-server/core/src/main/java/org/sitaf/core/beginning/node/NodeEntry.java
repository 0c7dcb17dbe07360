package org.sitaf.core.beginning.node;

/**
 * What can be run of a package.
 *
 * @param isMain whether it is a function or source of a program, otherwise a class
 * @param name as {@code main} or {@code class} of {@code activity.yaml} names it
 * @param file its source, relative to the package
 */
record NodeEntry(boolean isMain, String name, String file) {}
