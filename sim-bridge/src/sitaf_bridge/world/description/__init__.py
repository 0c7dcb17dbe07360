"""World descriptions: files, parsing, and the checks that do not need MuJoCo."""
