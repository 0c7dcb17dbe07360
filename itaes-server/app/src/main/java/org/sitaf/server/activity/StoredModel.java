package org.sitaf.server.activity;

import jakarta.persistence.Embeddable;
import org.jspecify.annotations.Nullable;

/**
 * A test model of an activity.
 *
 * @param path of its document
 * @param interfaceName null if the model does not name an interface
 */
@Embeddable
record StoredModel(String name, String path, @Nullable String interfaceName, String method) {}
