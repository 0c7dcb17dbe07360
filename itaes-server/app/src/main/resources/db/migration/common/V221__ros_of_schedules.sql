-- What ROS 2 nodes of the schedule's builds run with: INCLUDED or SYSTEM.
ALTER TABLE schedule ADD COLUMN ros VARCHAR(20) DEFAULT 'INCLUDED' NOT NULL;
