package org.sitaf.server.story;

import org.junit.jupiter.api.Tag;

/** Builds with an H2 file. */
@Tag("slow")
class BuildStoryTest extends BuildStory {}
