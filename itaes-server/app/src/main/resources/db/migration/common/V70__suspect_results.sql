-- Why the verdicts of a build are not to be trusted, a reason a line; null where nothing speaks against them.
ALTER TABLE build ADD COLUMN suspicions VARCHAR(8000);
