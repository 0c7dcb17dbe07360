package org.sitaf.server.build.recording;

import java.time.Instant;

/**
 * The recording of a case.
 *
 * @param sha256 of its binary glTF, in hexadecimal
 * @param size in bytes
 */
public record Recording(int caseNo, String sha256, long size, Instant received) {}
