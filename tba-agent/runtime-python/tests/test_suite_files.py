"""Reading suites and writing results."""

import os
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from sitaf_runtime.errors import CannotRunError, CaseDataError
from sitaf_runtime.suite.kinds import INT32, STRING
from sitaf_runtime.suite.reader import SuiteReader
from sitaf_runtime.suite.result import CaseResult, ResultsFile
from sitaf_runtime.suite.test_case import TestCase

HEAD = '<test_suite_data><case_param_info><param name="a"/><param name="b"/></case_param_info><case_list>'
CASE = "<case><value>1</value><value>x</value><expected>2</expected></case>"


def read(tmp_path, text):
    file = tmp_path / "suite.xml"
    file.write_text(text, "utf-8")
    reader = SuiteReader(file)
    try:
        return list(reader)
    finally:
        reader.close()


def test_cases_are_read_in_order(tmp_path):
    cases = read(
        tmp_path,
        HEAD + CASE + '<case no="7" class="invalid"><value>&lt;2</value><value/><expected name="r"/></case>'
        "</case_list></test_suite_data>",
    )
    assert [(c.no, c.valid, dict(c.values)) for c in cases] == [
        (1, True, {"a": "1", "b": "x"}),
        (7, False, {"a": "<2", "b": ""}),
    ]
    assert cases[0].read("a", INT32) == 1
    with pytest.raises(CaseDataError, match="generate the test application again"):
        cases[0].read("c", STRING)


SEQUENCE = (
    '<test_suite_data><case_param_info><param name="a"/></case_param_info>'
    '<step_param_info><step name="Read"><param name="i"/></step><step name="Nears"/></step_param_info><case_list>'
    '<case no="4"><value>5</value><step name="Read" class="invalid"><value>-1</value><expected>0</expected></step>'
    '<step name="Nears"/></case></case_list></test_suite_data>'
)


def test_a_sequence_has_steps(tmp_path):
    (case,) = read(tmp_path, SEQUENCE)
    assert dict(case.values) == {"a": "5"}
    assert [(s.no, s.number, s.name, s.valid, dict(s.values)) for s in case.steps] == [
        (4, 1, "Read", False, {"i": "-1"}),
        (4, 2, "Nears", True, {}),
    ]
    record = CaseResult(case.steps[0])
    record.began_at(100_000_000)
    assert record.line() == (
        b'<step_record no="4" step="1" name="Read" outcome="RETURNED" at_ns="100000000"></step_record>\n'
    )


def test_a_step_without_all_of_its_values_is_rejected(tmp_path):
    with pytest.raises(CaseDataError, match=r"step 1 \(Read\) of case 4 has 0 values for 1 parameters"):
        read(tmp_path, SEQUENCE.replace("<value>-1</value>", ""))


def test_a_long_suite_is_read_to_its_end(tmp_path):
    assert len(read(tmp_path, HEAD + CASE * 5000 + "</case_list></test_suite_data>")) == 5000


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("<!DOCTYPE x [<!ENTITY a 'b'>]>" + HEAD, "DTD"),
        ("<other/>", "the root is <other>"),
        ("<test_suite_data/>", "no <case_list>"),
        (HEAD.replace('"b"', '"a"'), "two parameters are named 'a'"),
        (HEAD + "<case><value>1</value></case>", "1 values for 2 parameters"),
        (HEAD + "<case><oops/></case>", "<oops> is unknown"),
        ("", "no element found"),
    ],
)
def test_a_document_that_is_no_suite_is_rejected(tmp_path, text, problem):
    with pytest.raises(CaseDataError, match=problem):
        read(tmp_path, text)


def test_cases_before_an_error_are_returned_first(tmp_path):
    file = tmp_path / "suite.xml"
    file.write_text(HEAD + CASE + CASE + "<case><oops>")
    reader = SuiteReader(file)
    seen = []
    with pytest.raises(CaseDataError):
        seen.extend(case.no for case in reader)
    reader.close()
    assert seen == [1, 2]


def test_a_record_with_any_text_is_one_line_of_xml(tmp_path):
    nasty = "a\nb\t<c>&\"'\u2028\x85\0\ud800"
    result = CaseResult(TestCase(3, True, {}))
    result.record("return", nasty, STRING)
    result.set_time(1.5, 0.25, 0)
    line = result.line()
    assert line.count(b"\n") == 1
    assert len(line.decode().splitlines()) == 1
    element = ElementTree.fromstring(line)
    assert element.findtext("actual") == nasty.replace("\0", "\\u0000").replace("\ud800", "\\uD800")
    assert element.attrib == {"no": "3", "outcome": "RETURNED"}
    assert element.find("processing_time").attrib["hardware"] == "0.250"


def test_the_type_name_of_an_exception_is_recorded():
    result = CaseResult(TestCase(1, True, {}))
    result.threw(ValueError("no"), "ValueError: no")
    assert result.line() == (
        b'<case_record no="1" outcome="THREW"><thrown>ValueError</thrown>'
        b"<message>ValueError: no</message></case_record>\n"
    )


def test_a_return_without_a_value_is_null():
    result = CaseResult(TestCase(1, True, {}))
    result.record_return("return")
    assert b'<actual name="return">null</actual>' in result.line()


def test_results_are_appended_after_an_incomplete_line(tmp_path):
    file = tmp_path / "results"
    first = ResultsFile(file, append=False)
    first.ready()
    first.close()
    with file.open("a") as incomplete:
        incomplete.write("<case_record no")
    again = ResultsFile(file, append=True)
    again.save(CaseResult(TestCase(1, True, {})))
    again.close()
    assert file.read_text().splitlines() == [
        "",
        "<case_record no",
        '<case_record no="1" outcome="RETURNED"></case_record>',
    ]


@pytest.fixture
def standard_input():
    """Replace standard input; the returned function sets its text."""
    before = os.dup(0)

    def holds(text):
        reading, writing = os.pipe()
        os.write(writing, text)
        os.close(writing)
        os.dup2(reading, 0)
        os.close(reading)

    yield holds
    os.dup2(before, 0)
    os.close(before)


def test_lines_on_a_descriptor_start_with_number_and_token(standard_input):
    standard_input(b"secret\nrest")
    reading, writing = os.pipe()
    results = ResultsFile(Path(f"fd:{writing}"), append=True)
    with pytest.raises(OSError, match="Bad file descriptor"):
        os.fstat(writing)
    results.ready()
    results.save(CaseResult(TestCase(7, True, {})))
    results.close()
    assert os.read(reading, 1000) == b'1 secret \n2 secret <case_record no="7" outcome="RETURNED"></case_record>\n'
    assert os.read(0, 10) == b"rest"
    os.close(reading)


def test_a_descriptor_without_a_token_is_rejected(standard_input):
    standard_input(b"")
    with pytest.raises(CannotRunError, match="no line with a token"):
        ResultsFile(Path("fd:1"), append=False)
