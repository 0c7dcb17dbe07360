"""`./sitaf lock`: the exact packages of an activity."""

import re
import shutil
import xml.etree.ElementTree as ElementTree

import pytest


@pytest.fixture
def activity(sitaf, tmp_path):
    return shutil.copytree(sitaf.root / "examples" / "simple-pid", tmp_path / "pid")


def test_builds_use_what_the_lock_lists(sitaf, activity, tmp_path):
    lock = activity / "activity.lock"
    results = tmp_path / "results"
    first = sitaf("lock", activity)
    assert first.returncode == 0, first.stderr
    assert "simple-pid 2.0.1" in first.stdout
    digest = re.search(
        r'name: "simple-pid"\n  version: "2.0.1"\n  sha256: "([0-9a-f]{64})"',
        lock.read_text(),
    ).group(1)
    again = sitaf("lock", activity)
    assert (again.returncode, "is up to date" in again.stdout) == (0, True), again.stderr

    ran = sitaf("run", activity, "--result", results)
    assert ran.returncode == 0, ran.stdout + ran.stderr
    provenance = ElementTree.parse(next(results.glob("*.xml"))).getroot().find("provenance")
    assert provenance.attrib["compiler"].startswith("Python 3.")
    assert {"name": "simple-pid", "version": "2.0.1", "sha256": digest} in [p.attrib for p in provenance.findall("package")]

    lock.write_text(lock.read_text().replace(digest, digest[::-1]))
    for command in ("lock", "run"):
        refused = sitaf(command, activity)
        assert refused.returncode == 2, refused.stdout + refused.stderr
        assert re.search(
            r"activity\.lock.*simple-pid 2\.0\.1.*--update",
            refused.stdout + refused.stderr,
            re.DOTALL,
        )
    updated = sitaf("lock", activity, "--update")
    assert updated.returncode == 0, updated.stderr
    assert "simple-pid 2.0.1, another file" in updated.stdout
    assert digest in lock.read_text()


def test_a_maven_package_with_what_it_needs(sitaf, tmp_path):
    folder = tmp_path / "text"
    (folder / "adapter" / "demo").mkdir(parents=True)
    (folder / "activity.yaml").write_text(
        "name: text\ncomponent:\n  language: java\n  package: org.apache.commons:commons-text:1.10.0\n"
        "  adapter: adapter/\n  class: demo.Distance\nprovided: [text.idl]\nmodels: [Of.xml]\n"
    )
    (folder / "text.idl").write_text("interface Distance { long Of(in long n); };\n")
    (folder / "Of.xml").write_text(
        '<test_model><name>Of</name><input_spec_list><test_element abstract_type="NUMERIC" real_type="int"><name>n</name>'
        "<type>TDI</type><user_value_list><value>1</value><value>2</value></user_value_list></test_element></input_spec_list>"
        "<output_spec_list/><order_of_combinations>all</order_of_combinations></test_model>\n"
    )
    (folder / "adapter" / "demo" / "Distance.java").write_text(
        "package demo;\nimport org.apache.commons.lang3.StringUtils;\n"
        "import org.apache.commons.text.similarity.LevenshteinDistance;\n"
        "public class Distance {\n  public int Of(int n) {\n"
        '    return LevenshteinDistance.getDefaultInstance().apply(StringUtils.repeat("a", n), "");\n  }\n}\n'
    )
    locked = sitaf("lock", folder)
    assert locked.returncode == 0, locked.stderr
    text = (folder / "activity.lock").read_text()
    assert 'name: "org.apache.commons:commons-text"\n  version: "1.10.0"' in text
    assert 'name: "org.apache.commons:commons-lang3"' in text
    ran = sitaf("run", folder)
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_an_invalid_lock_is_reported_with_its_line(sitaf, activity):
    (activity / "activity.lock").write_text("packages:\n- {name: simple-pid, version: '--pre', sha256: aa}\n")
    done = sitaf("run", activity)
    assert done.returncode == 2
    assert "activity.lock:2" in done.stderr
    assert "'--pre' is not a version" in done.stderr
