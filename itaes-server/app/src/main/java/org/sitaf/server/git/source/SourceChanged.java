package org.sitaf.server.git.source;

/** Published after the settings of a source were stored. */
public record SourceChanged(String sourceId, int intervalS) {}
