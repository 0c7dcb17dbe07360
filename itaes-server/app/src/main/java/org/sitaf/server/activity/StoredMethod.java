package org.sitaf.server.activity;

import jakarta.persistence.Embeddable;

/**
 * A method of an interface that the component provides or requires.
 *
 * @param required whether the component requires it
 * @param method name and parameter types, such as {@code GetInfraredData(int32,int32)}
 */
@Embeddable
record StoredMethod(String interfaceName, boolean required, String method) {}
