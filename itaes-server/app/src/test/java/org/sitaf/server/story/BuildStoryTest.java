package org.sitaf.server.story;

import org.junit.jupiter.api.Tag;

/** Builds, on H2 in a file. */
@Tag("slow")
class BuildStoryTest extends BuildStory {}
