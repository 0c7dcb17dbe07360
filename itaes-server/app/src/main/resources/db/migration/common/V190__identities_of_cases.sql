-- Equal in all results that have the same case, whatever its number is; see CaseIdentity. V191 fills
-- it for existing results.
ALTER TABLE result_case ADD COLUMN fingerprint VARCHAR(32);
CREATE INDEX result_case_by_fingerprint ON result_case (build_id, fingerprint);
