-- To find contents that nothing refers to.
CREATE INDEX build_file_by_content ON build_file (sha256);
CREATE INDEX workspace_file_by_content ON workspace_file (sha256);
