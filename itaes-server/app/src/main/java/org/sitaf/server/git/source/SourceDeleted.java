package org.sitaf.server.git.source;

/** Published after a source was deleted. */
public record SourceDeleted(String sourceId) {}
