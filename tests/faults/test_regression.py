"""Runs the program of this folder in its short form; it checks its own targets."""


def test_commits_build_what_they_touch_and_each_has_one_final_status(installed):
    # The full program also has components in C++, whose runtime takes a minute, and measures how long a push takes.
    ran = installed("bench", "regression", "--commits", "12", "--activities", "2", "--kills", "2", "--pushes", "0")
    assert ran.returncode == 0, ran.stdout + ran.stderr
    assert ran.stdout.splitlines()[-1] == "regression: held", ran.stdout
