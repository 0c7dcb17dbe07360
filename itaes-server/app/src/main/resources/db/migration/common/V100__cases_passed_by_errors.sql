-- The cases that passed by an exception; null for builds before this column.
ALTER TABLE build ADD COLUMN by_error INTEGER;
