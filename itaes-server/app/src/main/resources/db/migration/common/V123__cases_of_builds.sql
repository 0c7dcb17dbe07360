-- The cases that were requested, such as 9,12-20; null for all.
ALTER TABLE build ADD COLUMN case_numbers VARCHAR(100000);
