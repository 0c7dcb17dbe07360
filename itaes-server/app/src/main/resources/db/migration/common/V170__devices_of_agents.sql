-- Names of the real devices that an agent offers, separated by commas; at most 100 of 128 characters.
ALTER TABLE agent ADD COLUMN devices VARCHAR(13000) DEFAULT '' NOT NULL;
