package org.sitaf.server.storage;

/** There is room on the disks again, for all work or for that which had been taken. */
public record RoomAgain() {}
