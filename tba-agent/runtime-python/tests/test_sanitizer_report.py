"""Reports of sanitizers, which a node may forge or remove."""

import os

import pytest

from sitaf_runtime.ros import sanitizer_report

OVERFLOW = """=================================================================
==17==ERROR: AddressSanitizer: heap-buffer-overflow on address 0x60200004c8bc at pc 0x7f bp 0x7f sp 0x7f
READ of size 4 at 0x60200004c8bc thread T0
    #0 0x7f0 in std::vector<float>::operator[](unsigned long) /usr/include/c++/12/bits/stl_vector.h:1123
    #1 0x7f1 in MeanRange::on_scan(std::shared_ptr<a const>) activity/src/mean_range/src/mean_range.cpp:31
    #2 0x7f2 in main activity/src/mean_range/src/other.cpp:5
allocated by thread T0 here:
    #0 0x7f3 in operator new(unsigned long) (/usr/lib/libasan.so.8+0xb9)
SUMMARY: AddressSanitizer: heap-buffer-overflow /usr/include/c++/12/bits/stl_vector.h:1123 in operator[]
"""
UNDEFINED = """activity/src/node.cpp:37:40: runtime error: signed integer overflow: 2147483181 + 500 is too large
    #0 0x7f in on_scan activity/src/node.cpp:37
"""


@pytest.mark.parametrize(
    ("text", "cause"),
    [
        (OVERFLOW, "heap-buffer-overflow at mean_range.cpp:31"),
        (OVERFLOW.replace("activity/", "/opt/"), "heap-buffer-overflow"),
        ("==1==ERROR: AddressSanitizer: SEGV on unknown address 0x0\n", "SEGV"),
        (UNDEFINED, "signed integer overflow: 2147483181 + 500 is too large at node.cpp:37"),
        ("the node printed this\n" * 3, ""),
        (f"{'#0 x ' * 5000}\n", ""),
    ],
)
def test_the_cause_is_the_kind_and_the_first_line_of_the_node(text, cause):
    assert sanitizer_report.cause(text) == cause


@pytest.fixture
def report(tmp_path, monkeypatch):
    monkeypatch.setenv(sanitizer_report.VARIABLE, str(tmp_path / "report"))
    return tmp_path / f"report.{os.getpid()}"


def test_a_report_is_copied_to_standard_error_once(report, capfd):
    report.write_text(OVERFLOW)
    assert sanitizer_report.of(os.getpid()) == "heap-buffer-overflow at mean_range.cpp:31"
    assert "READ of size 4" in capfd.readouterr().err
    assert not report.exists()
    assert sanitizer_report.of(os.getpid()) == ""


def test_a_link_and_a_pipe_in_the_place_of_a_report_are_not_read(report, tmp_path):
    (tmp_path / "secret").write_text(OVERFLOW)
    report.symlink_to(tmp_path / "secret")
    assert sanitizer_report.of(os.getpid()) == ""
    report.unlink(missing_ok=True)
    os.mkfifo(report)
    assert sanitizer_report.of(os.getpid()) == ""


def test_without_a_sanitizer_there_is_no_report(monkeypatch):
    monkeypatch.delenv(sanitizer_report.VARIABLE, raising=False)
    assert sanitizer_report.of(os.getpid()) == ""
