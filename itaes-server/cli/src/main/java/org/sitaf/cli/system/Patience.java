package org.sitaf.cli.system;

import java.time.Duration;

/**
 * How long a process is waited for.
 *
 * @param withoutProgress while it does nothing at all
 * @param atMost whatever it does
 */
record Patience(Duration withoutProgress, Duration atMost) {}
