package org.sitaf.server.git;

import org.junit.jupiter.api.Tag;

/** Searches with H2. */
@Tag("slow")
class BisectionStoryTest extends BisectionStory {}
