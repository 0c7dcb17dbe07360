"""Hostile uploads: bodies for POST /api/v1/activities and the allowed status codes.

`uploads()` lists them; no server is spoken with here. `python3 uploads.py FOLDER` writes them below a folder, with `index.json`.
"""

import gzip
import io
import json
import struct
import sys
import time
import zipfile
import zlib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

EXAMPLE = Path(__file__).resolve().parents[3] / "examples" / "ir-sensor"
PROFILE, MODEL, WORLD = "activity.yaml", "GetInfraredData.xml", "world/ir.world.yaml"
ZIP = "application/zip"
MIB = 1 << 20
DEFLATED, ENCRYPTED, DESCRIPTOR, UTF8_NAME = 8, 0x1, 0x8, 0x800

# Allowed status codes for invalid uploads: never a server error.
REFUSED = frozenset({400, 413, 422})
# Unusual but valid: may be accepted.
ODD = REFUSED | {201}


class Upload(NamedTuple):
    """A body is bytes, or an iterable of pieces that are sent with the transfer encoding `chunked`."""

    name: str
    content_type: str
    body: bytes | Callable[[], Iterator[bytes]]
    expected: frozenset


def example():
    return {p.relative_to(EXAMPLE).as_posix(): p.read_bytes() for p in sorted(EXAMPLE.rglob("*")) if p.is_file()}


def archive(files):
    """A zip of entries in their order, duplicates among them."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as made:
        for name, content in files.items() if isinstance(files, dict) else files:
            info = zipfile.ZipInfo(name, (1980, 1, 1, 0, 0, 0))
            info.compress_type = zipfile.ZIP_DEFLATED
            made.writestr(info, content)
    return out.getvalue()


def with_files(**changed):
    """The example with other files; in the names, `__` stands for a slash and `_dot_` for a dot."""
    files = example()
    files.update({name.replace("__", "/").replace("_dot_", "."): content for name, content in changed.items()})
    return archive(files)


def with_file(name, content):
    return archive({**example(), name: content})


def deflate(content):
    packer = zlib.compressobj(9, zlib.DEFLATED, -15)
    return packer.compress(content) + packer.flush()


def local(name, data, content, flags=UTF8_NAME, method=DEFLATED, crc=None, packed=None, unpacked=None, extra=b"", tail=b""):
    """An entry with a header that may be wrong."""
    name = name if isinstance(name, bytes) else name.encode()
    crc = zlib.crc32(content) if crc is None else crc
    packed = len(data) if packed is None else packed
    unpacked = len(content) if unpacked is None else unpacked
    header = struct.pack("<4sHHHHHIIIHH", b"PK\3\4", 45, flags, method, 0, 33, crc, packed, unpacked, len(name), len(extra))
    return header + name + extra + data + tail


def raw(*entries):
    """Entries and an end record; stream readers ignore the central directory."""
    return b"".join(entries) + struct.pack("<4sHHHHIIH", b"PK\5\6", 0, 0, 0, 0, 0, 0, 0)


def example_entries(but=()):
    return [local(n, deflate(c), c) for n, c in example().items() if n not in but]


def symlink(name, target):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w") as made:
        for path, content in example().items():
            made.writestr(path, content)
        info = zipfile.ZipInfo(name)
        info.create_system, info.external_attr = 3, 0o120777 << 16
        made.writestr(info, target)
    return out.getvalue()


def many(count, suffix=""):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_STORED) as made:
        for number in range(count):
            made.writestr(f"d{number % 100}/{number}{suffix}", b"")
    return out.getvalue()


def overlapping(kernel_mib=16, copies=256):
    """A central directory whose entries share one position; a reader of it unpacks that position repeatedly."""
    content = bytes(kernel_mib * MIB)
    data, crc = deflate(content), zlib.crc32(content)
    body, directory = local("0", data, content), b""
    for number in range(copies):
        name = str(number).encode()
        directory += struct.pack(
            "<4sHHHHHHIIIHHHHHII",
            b"PK\1\2", 45, 45, 0, DEFLATED, 0, 33, crc, len(data), len(content), len(name), 0, 0, 0, 0, 0, 0,
        ) + name
    end = struct.pack("<4sHHHHIIH", b"PK\5\6", 0, 0, copies, copies, len(directory), len(body), 0)
    return body + directory + end


def nested_bomb(depth=6):
    """Zips within zips; a reader that unpacks one level gets a small file."""
    inner = archive({"zeros": bytes(4 * MIB)})
    for level in range(depth):
        inner = archive({f"{level}-{copy}.zip": inner for copy in range(8)})
    return with_file("component/nested.zip", inner)


def quine():
    """An archive that claims to contain itself."""
    own = archive({"r.zip": b""})
    for _ in range(3):
        own = archive({"r.zip": own})
    return own


def model(replacement):
    """The example with another document of its model."""
    return with_file(MODEL, replacement)


def laughs():
    entities = ['<!ENTITY l0 "ha">'] + [f'<!ENTITY l{n} "{f"&l{n - 1};" * 10}">' for n in range(1, 10)]
    return f'<?xml version="1.0"?><!DOCTYPE test_model [{"".join(entities)}]><test_model><name>&l9;</name></test_model>'.encode()


def entity(system):
    return (
        f'<!DOCTYPE test_model [<!ENTITY x SYSTEM "{system}">]><test_model><name>&x;</name></test_model>'
    ).encode()


def profile(text):
    return with_file(PROFILE, text if isinstance(text, bytes) else text.encode())


def yaml():
    return example()[PROFILE].decode()


def aliases():
    lines = ["a0: &a0 [x, x, x, x, x, x, x, x, x]"]
    lines += [f"a{n}: &a{n} [{', '.join([f'*a{n - 1}'] * 9)}]" for n in range(1, 10)]
    return "\n".join(lines) + "\n" + yaml()


def many_models(count):
    document = example()[MODEL].decode()
    names = [f"models/M{number}.xml" for number in range(count)]
    files = example() | {name: document.replace("<name>GetInfraredData", f"<name>M{n}", 1).encode() for n, name in enumerate(names)}
    files[PROFILE] = yaml().replace("models: [GetInfraredData.xml]", f"models: [{', '.join(names)}]").encode()
    return archive(files)


def drip(content, first, pieces, pause_s):
    """Start normally, then send single bytes with pauses."""

    def give():
        yield content[:first]
        for position in range(first, first + pieces):
            time.sleep(pause_s)
            yield content[position : position + 1]

    return give


def in_chunks(content, size):
    def give():
        for position in range(0, len(content), size):
            yield content[position : position + size]

    return give


def names():
    """Entries with invalid or confusable names."""
    bad = {
        "zip slip": "../../../../tmp/sitaf-slip",
        "zip slip in the middle": "component/../../x",
        "absolute path": "/tmp/sitaf-absolute",
        "drive letter and backslashes": "C:\\Windows\\x",
        "backslashes that climb": "..\\..\\x",
        "name with NUL": "component/a\0b",
        "name with escape sequence": "component/\x1b[2J\x1b]0;x\7",
        "name with line feed": "component/a\nb",
        "name that runs backwards": "component/\u202efdp.java",
        "name with a line separator": "component/a\u2028b",
        "name of 100,000 characters": "a" * 60_000,
        "name of 300 bytes": "component/" + "ü" * 150,
        "folder 5,000 deep": "d/" * 5_000 + "x",
        "folder 190 deep": "d/" * 190 + "x",
        "empty name": "",
        "only a dot": ".",
        "double slash": "component//x",
    }
    found = []
    for name, path in bad.items():
        entries = [*example_entries(), local(path, deflate(b"x"), b"x")]
        found.append(Upload(name, ZIP, raw(*entries), REFUSED))
    found.append(Upload("name that is no UTF-8", ZIP, raw(*example_entries(), local(b"\xff\xfe\xc3(", deflate(b"x"), b"x")), REFUSED))
    return found


def entries():
    """Archives with contradicting entries or special files."""
    own = example()
    return [
        Upload("duplicate entries", ZIP, archive([*own.items(), (PROFILE, own[PROFILE])]), REFUSED),
        Upload("duplicate entries of other content", ZIP, archive([*own.items(), (PROFILE, b"name: x")]), REFUSED),
        Upload("names that differ in case", ZIP, with_file("component/org/sitaf/examples/ir/INFRAREDSENSOR.java", b"class X {}"), ODD),
        Upload("a file that is a folder too", ZIP, with_file("component/org", b"x"), REFUSED),
        Upload("a link out of the archive", ZIP, symlink("component/passwd", "/etc/passwd"), ODD),
        Upload("a link to a folder, and a file in it", ZIP, archive([*own.items(), ("link", b"/etc"), ("link/x", b"x")]), REFUSED),
        Upload("100,000 entries", ZIP, many(100_000), REFUSED),
        Upload("100,000 folders", ZIP, many(100_000, "/"), REFUSED),
        Upload("a custom driver", ZIP, with_file("harness/GetInfraredData/ConcreteTestDriver.java", b"class X { static { System.exit(1); } }"), ODD),
        Upload("a driver of a model that is none", ZIP, with_file("harness/../harness/x", b"x"), REFUSED),
        Upload("9,900 models", ZIP, many_models(9_900), REFUSED),
        Upload("10,001 models", ZIP, many_models(10_001), REFUSED),
        Upload("no profile", ZIP, archive({"readme.txt": b"x"}), REFUSED),
        Upload("folders only", ZIP, many(10, "/"), REFUSED),
    ]


def bombs():
    """Small archives that are large when unpacked."""
    zeros = bytes(250 * MIB)
    return [
        Upload("250 MiB of zeros", ZIP, with_file("component/zeros", zeros), REFUSED),
        Upload("250 files of a MiB", ZIP, archive({**example(), **{f"z/{n}": bytes(MIB) for n in range(250)}}), REFUSED),
        Upload("zips in zips", ZIP, nested_bomb(), ODD),
        Upload("an archive in itself", ZIP, quine(), REFUSED),
        Upload("entries that overlap", ZIP, overlapping(), REFUSED),
        Upload("zeros in a folder's entry", ZIP, raw(local("d/", deflate(zeros), zeros), *example_entries()), REFUSED),
    ]


def lies():
    """Wrong headers."""
    good, content = with_files(), example()[PROFILE]
    data, others = deflate(content), example_entries(but=(PROFILE,))
    zip64 = struct.pack("<HHQQ", 1, 16, 1 << 62, 1 << 62)
    negative = struct.pack("<HHQQ", 1, 16, (1 << 64) - 1, (1 << 64) - 1)
    return [
        Upload("nothing", ZIP, b"", REFUSED),
        Upload("no zip", ZIP, b"no zip" * 1000, REFUSED),
        Upload("cut off in the middle", ZIP, good[: len(good) // 2], REFUSED),
        Upload("cut off in the first entry", ZIP, good[:60], REFUSED),
        Upload("cut off before the directory", ZIP, b"".join(example_entries()), ODD),
        Upload("wrong checksum", ZIP, raw(local(PROFILE, data, content, crc=1), *others), REFUSED),
        Upload("stored, with the wrong size", ZIP, raw(local(PROFILE, content, content, method=0, packed=10, unpacked=10), *others), REFUSED),
        Upload("zip64 of 4 EiB", ZIP, raw(local(PROFILE, data, content, packed=0xFFFFFFFF, unpacked=0xFFFFFFFF, extra=zip64), *others), REFUSED),
        Upload("zip64 of a negative size", ZIP, raw(local(PROFILE, data, content, packed=0xFFFFFFFF, unpacked=0xFFFFFFFF, extra=negative), *others), REFUSED),
        Upload("zip64 field that is cut off", ZIP, raw(local(PROFILE, data, content, packed=0xFFFFFFFF, unpacked=0xFFFFFFFF, extra=zip64[:7]), *others), REFUSED),
        Upload("encrypted", ZIP, raw(local(PROFILE, b"\0" * 12 + data, content, flags=ENCRYPTED), *others), REFUSED),
        Upload("a descriptor that lies", ZIP, raw(local(PROFILE, data, content, flags=DESCRIPTOR | UTF8_NAME, crc=0, packed=0, unpacked=0, tail=struct.pack("<4sIII", b"PK\7\x08", 1, 2, 3)), *others), REFUSED),
        Upload("a descriptor after stored bytes", ZIP, raw(local(PROFILE, content, content, flags=DESCRIPTOR, method=0, crc=0, packed=0, unpacked=0, tail=struct.pack("<4sIII", b"PK\7\x08", 1, 2, 3)), *others), REFUSED),
        Upload("an unknown compression method", ZIP, raw(local(PROFILE, data, content, method=99), *others), REFUSED),
        Upload("deflated noise", ZIP, raw(local(PROFILE, bytes(range(256)) * 8, content), *others), REFUSED),
        Upload("an extra field beyond its end", ZIP, raw(local(PROFILE, data, content, extra=b"\1\0\xff\xff")) , REFUSED),
        Upload("something before the zip", ZIP, b"#!/bin/sh\nexit\n" + good, REFUSED),
        Upload("something after the zip", ZIP, good + b"<?php ?>" * 100, ODD),
    ]


def xml_documents():
    document = example()[MODEL].decode()
    service = example()["InfraredSensorService.xml"].decode()
    parameters = "".join(f'<param index="{n}"><name>p{n}</name><type>string</type></param>' for n in range(1, 101))
    method = f'<method name="Long" return_type="void" call_type="blocking">{parameters}</method></service_port_type>'
    return [
        Upload("XML: an entity of a file", ZIP, model(entity("file:///etc/passwd")), REFUSED),
        Upload("XML: an entity of an address", ZIP, model(entity("http://127.0.0.1:9/x")), REFUSED),
        Upload("XML: a billion laughs", ZIP, model(laughs()), REFUSED),
        Upload("XML: 100,000 deep", ZIP, model(b"<a>" * 100_000 + b"</a>" * 100_000), REFUSED),
        Upload("XML: an attribute of 8 MiB of noise", ZIP, model(b'<test_model a="' + bytes(97 + (n * n % 23) for n in range(MIB)) * 8 + b'"/>'), REFUSED),
        Upload("XML: 100,000 attributes", ZIP, model(b"<test_model " + b" ".join(b'a%d=""' % n for n in range(100_000)) + b"/>"), REFUSED),
        Upload("XML: cut off", ZIP, model(document[:200].encode()), REFUSED),
        Upload("XML: declared UTF-16, written UTF-8", ZIP, model(document.replace("UTF-8", "UTF-16").encode()), REFUSED),
        Upload("XML: UTF-16", ZIP, model(document.replace("UTF-8", "UTF-16").encode("utf-16")), ODD),
        Upload("XML: UTF-7", ZIP, model(document.replace("UTF-8", "UTF-7").encode("utf-7")), REFUSED),
        Upload("XML: no UTF-8", ZIP, model(document.replace("GetInfraredData", "Get\xff", 1).encode("latin-1")), REFUSED),
        Upload("XML: an unknown encoding", ZIP, model(document.replace("UTF-8", "x-none").encode()), REFUSED),
        Upload("XML: an include", ZIP, model(document.replace("<name>", '<xi:include xmlns:xi="http://www.w3.org/2001/XInclude" href="/etc/passwd" parse="text"/><name>', 1).encode()), REFUSED),
        Upload("XML: a stylesheet", ZIP, model(document.replace("<test_model>", '<?xml-stylesheet href="http://127.0.0.1:9/x"?><test_model>', 1).encode()), ODD),
        Upload("XML: a signature of 700 characters", ZIP, with_file("InfraredSensorService.xml", service.replace("</service_port_type>", method, 1).encode()), ODD),
        Upload("XML: a name of 1 MiB", ZIP, model(document.replace("GetInfraredData</name>", "N" * MIB + "</name>", 1).encode()), REFUSED),
    ]


def yaml_documents():
    text = yaml()
    return [
        Upload("YAML: aliases that multiply", ZIP, profile(aliases()), REFUSED),
        Upload("YAML: a tag that makes an object", ZIP, profile("x: !!javax.script.ScriptEngineManager [!!java.net.URLClassLoader [[!!java.net.URL ['http://127.0.0.1:9/']]]]\n" + text), REFUSED),
        Upload("YAML: 100,000 deep", ZIP, profile("[" * 100_000), REFUSED),
        Upload("YAML: 100,000 maps deep", ZIP, profile("{a: " * 100_000), REFUSED),
        Upload("YAML: an alias of itself", ZIP, profile("name: &a [*a]\n" + text), REFUSED),
        Upload("YAML: merged with itself", ZIP, profile(text + "<<: {name: x}\n"), REFUSED),
        Upload("YAML: keys twice", ZIP, profile(text + "name: other\n"), REFUSED),
        Upload("YAML: UTF-16", ZIP, profile(text.encode("utf-16")), ODD),
        Upload("YAML: no UTF-8", ZIP, profile(text.encode() + b"\xc3\x28: x\n"), REFUSED),
        Upload("YAML: a NUL", ZIP, profile(text.replace("ir-sensor", "ir\0sensor", 1)), REFUSED),
        Upload("YAML: a name of 1,000 characters", ZIP, profile(text.replace("name: ir-sensor", "name: " + "n" * 1_000)), REFUSED),
        Upload("YAML: a description of 10,000 characters", ZIP, profile(text.replace("description: ", "description: " + "d" * 10_000)), REFUSED),
        Upload("YAML: a class of 2,000 characters", ZIP, profile(text.replace("class: org", "class: " + "c." * 1_000 + "org")), REFUSED),
        Upload("YAML: sources out of the tree", ZIP, profile(text.replace("sources: component/", "sources: ../../")), REFUSED),
        Upload("YAML: a model out of the tree", ZIP, profile(text.replace("[GetInfraredData.xml]", "[../../../../etc/passwd]")), REFUSED),
        Upload("YAML: an absolute world", ZIP, profile(text.replace("world/ir.world.yaml", "/etc/passwd")), REFUSED),
        Upload("YAML: an absolute interface", ZIP, profile(text.replace("[InfraredSensorService.xml]", "[/etc/passwd]")), REFUSED),
        Upload("YAML: limits that are no numbers", ZIP, profile(text.replace("memory_mb: 1024", "memory_mb: .nan")), REFUSED),
        Upload("YAML: limits beyond all", ZIP, profile(text.replace("case_wall_s: 10", "case_wall_s: 1e308")), ODD),
        Upload("YAML: an integer of 10,000 digits", ZIP, profile(text.replace("Size: 7", "Size: " + "9" * 10_000)), ODD),
        Upload("YAML: world of aliases", ZIP, with_file(WORLD, aliases().encode()), REFUSED),
    ]


def transports():
    """Bodies that differ from their headers."""
    good = with_files()
    return [
        Upload("another type", "text/plain", good, frozenset({415})),
        Upload("JSON instead", "application/json", b"{}", frozenset({415})),
        Upload("a form", "application/x-www-form-urlencoded", b"a=b" * 1000, frozenset({415})),
        Upload("several parts", "multipart/form-data; boundary=x", b"--x\r\n\r\n" + good + b"\r\n--x--", frozenset({415})),
        Upload("a type that is none", "zip", good, frozenset({400, 415})),
        Upload("packed by gzip", ZIP, gzip.compress(good), REFUSED),
        Upload("in chunks of 7 bytes", ZIP, in_chunks(good, 7), frozenset({201})),
        Upload("a byte a second", ZIP, drip(good, 100, 90, 1.0), frozenset({408})),
    ]


def uploads():
    """All uploads."""
    return [*names(), *entries(), *bombs(), *lies(), *xml_documents(), *yaml_documents(), *transports()]


def write(folder):
    folder.mkdir(parents=True, exist_ok=True)
    index = []
    for number, upload in enumerate(uploads()):
        whole = isinstance(upload.body, bytes)
        if whole:
            (folder / f"{number}.bin").write_bytes(upload.body)
        index.append({"name": upload.name, "type": upload.content_type, "file": f"{number}.bin" if whole else None, "expected": sorted(upload.expected)})
    (folder / "index.json").write_text(json.dumps(index))


if __name__ == "__main__":
    write(Path(sys.argv[1]))
