package org.sitaf.server.storage;

/** There is space on the disks again, for new work or at least for running work. */
public record DiskSpaceRecovered() {}
