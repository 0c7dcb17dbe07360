package org.sitaf.server.activity;

import jakarta.persistence.Embeddable;
import org.jspecify.annotations.Nullable;

/**
 * A test model of a workspace.
 *
 * @param path its document among the files
 * @param interfaceName null where the model leaves it open
 */
@Embeddable
record WorkspaceModel(String name, String path, @Nullable String interfaceName, String method) {}
