package org.sitaf.cli.system;

import java.time.Duration;

/**
 * How long to wait for a process.
 *
 * @param withoutProgress timeout without any progress
 * @param atMost total timeout
 */
record StartupTimeout(Duration withoutProgress, Duration atMost) {}
