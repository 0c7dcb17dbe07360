package org.sitaf.server.story;

/** Builds, on H2 in a file. */
class BuildStoryTest extends BuildStory {}
