package org.sitaf.server.file;

import jakarta.persistence.Embeddable;

/**
 * A file of an activity or a build.
 *
 * @param path relative, as in {@link org.sitaf.core.activity.FileTree}
 * @param sha256 of its content, in hexadecimal
 * @param size in bytes
 */
@Embeddable
public record StoredFile(String path, String sha256, long size) {}
