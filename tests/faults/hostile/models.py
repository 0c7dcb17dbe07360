"""Test models that need too many resources, as replacements for ir-sensor's GetInfraredData.xml.

``refused``: the model, or the generation of its cases, is refused with a message in numbers.
``error``: cases are generated, and each that meets the condition is an ERROR that says so.
``survived``: it looks hostile, is within the limits, and gives cases that pass.
"""

from __future__ import annotations

from random import Random
from typing import Literal, NamedTuple
from xml.sax.saxutils import escape

Expected = Literal["refused", "error", "survived"]

DIGITS = "[0,1,2,3,4,5,6,7,8,9]"
SAFE = "valid && IndexOfSensor <= NumOfSensor ? Distance : -1.0"


class Hostile(NamedTuple):
    """A model and its expected outcome."""

    name: str
    model: bytes
    expected: Expected


def nested(macro: str, depth: int, inner: str) -> str:
    """Nested loops over ten digits."""
    opened = "".join(f"{DIGITS}.{macro}(i{i}, " for i in range(depth))
    return opened + inner + ")" * depth


def element(name: str, kind: str, real_type: str, values: str) -> str:
    return (
        f'<test_element abstract_type="NUMERIC" real_type="{real_type}">'
        f"<name>{name}</name><type>{kind}</type>{values}</test_element>"
    )


def bva(low: str, high: str, offset: str) -> str:
    return (
        f'<test_spec type="BVA" offset="{offset}">'
        f'<equiv_class type="NEC_NUMERIC_TWO_BOUNDARY" min="{low}" max="{high}"/></test_spec>'
    )


def random(count: int, high: str) -> str:
    return f'<test_spec type="RANDOM" count="{count}" min="1" max="{high}"/>'


def digits(count: int) -> str:
    """A number that does not compress."""
    return "".join(Random(1).choices("123456789", k=count))


def listed(values: range) -> str:
    return "<user_value_list>" + "".join(f"<value>{v}</value>" for v in values) + "</user_value_list>"


def model(
    pre: list[str] | None = None,
    post: list[str] | None = None,
    expected: str = SAFE,
    index: str = bva("1", "7", "1"),
    number: str = bva("1", "7", "1"),
    distance: str = bva("0.0", "10.0", "0.5"),
    order: str = "2",
) -> bytes:
    """The model of ir-sensor with modifications."""
    before = "".join(f"<pre_condition>{escape(c)}</pre_condition>" for c in pre or [])
    after = "".join(f"<post_condition>{escape(c)}</post_condition>" for c in post or [])
    return (
        '<?xml version="1.0" encoding="UTF-8"?>\n<test_model><name>GetInfraredData</name>'
        '<target interface="InfraredSensorService" method="GetInfraredData"/>'
        + (f"<pre_condition_spec_list>{before}</pre_condition_spec_list>" if before else "")
        + "<input_spec_list>"
        + element("IndexOfSensor", "TDI", "int", index)
        + element("NumOfSensor", "TDI", "int", number)
        + element("Distance", "TDSD", "double", distance)
        + "</input_spec_list><output_spec_list>"
        + '<test_element abstract_type="NUMERIC" real_type="double"><name>return</name>'
        + f"<type>RETURN</type><expected>{escape(expected)}</expected>"
        + '<tolerance absolute="1e-9" relative="0"/></test_element></output_spec_list>'
        + (f"<post_condition_spec_list>{after}</post_condition_spec_list>" if after else "")
        + "<invalid_values>isolate</invalid_values>"
        + f"<order_of_combinations>{order}</order_of_combinations></test_model>\n"
    ).encode()


def models() -> list[Hostile]:
    """All kinds, ordered by their target."""
    doubled = ".map(s, s + s)" * 40
    text = f"['ab']{doubled}[0] == ''"
    shared = "['ab']" + ".map(s, [s, s])" * 30 + " == dyn([1])"
    conjunction = "IndexOfSensor == 1 && NumOfSensor == 2 && Distance == 3.0"
    wide = "(IndexOfSensor * 3 + NumOfSensor * 5 + int(Distance) * 7) % 10 == 3"
    return [
        Hostile("pre-all-14", model(pre=[nested("all", 14, "true")]), "refused"),
        Hostile("post-all-14", model(post=[nested("all", 14, "true")]), "refused"),
        Hostile("expected-all-14", model(expected=nested("all", 14, "true") + " ? 1.0 : 2.0"), "refused"),
        Hostile("post-exists-14", model(post=[nested("exists", 14, "false")]), "refused"),
        Hostile("post-map-9", model(post=[nested("map", 9, "1") + " != []"]), "refused"),
        Hostile("post-absorbed-errors", model(post=[nested("all", 9, "1 / 0 == 1 || true")]), "refused"),
        Hostile("type-doubled", model(post=["[1]" + ".map(i, {i: i})" * 40 + " != []"]), "refused"),
        Hostile("parentheses-10000", model(post=["(" * 10_000 + "true" + ")" * 10_000]), "refused"),
        Hostile("parentheses-9000", model(post=["(" * 9_000 + "true" + ")" * 9_000]), "refused"),
        Hostile("ternaries-1000", model(post=["valid ? true : " * 1_000 + "true"]), "refused"),
        Hostile("sum-of-3000", model(post=["0 + " * 3_000 + "0 == 0"]), "refused"),
        Hostile("literal-1-MB", model(post=["'" + "a" * 1_000_000 + "' != ''"]), "refused"),
        Hostile("unicode-literal", model(post=["'" + "é😀" * 20_000 + "' != ''"]), "refused"),
        Hostile("expected-text-doubled", model(expected=text + " ? 1.0 : 2.0"), "refused"),
        Hostile("pre-text-doubled", model(pre=[text]), "refused"),
        Hostile("post-text-doubled", model(post=[text]), "error"),
        Hostile("post-list-doubled", model(post=[f"[[1, 2]]{doubled}[0] != []"]), "error"),
        Hostile("post-bytes-doubled", model(post=[f"[b'ab']{doubled}[0] != b''"]), "error"),
        Hostile("post-shared-lists", model(post=[shared]), "error"),
        Hostile("post-regex-repeated", model(post=["'b'.matches('(((a{1000}){1000}){1000})')"]), "error"),
        Hostile("post-regex-long", model(post=["!'b'.matches(" + "'(a|b)*c' + " * 200 + "'')"]), "error"),
        Hostile("digits-3000000", model(index=f"<user_value_list><value>{digits(3_000_000)}</value></user_value_list>"), "refused"),
        Hostile("bound-of-3000000-digits", model(distance=bva("0.0", digits(3_000_000), "0.5")), "refused"),
        Hostile("values-300000", model(index=random(300_000, "2000000000")), "refused"),
        Hostile(
            "values-100000-conditioned",
            model(index=random(100_000, "2000000000"), pre=["IndexOfSensor != NumOfSensor"]),
            "refused",
        ),
        Hostile(
            "cases-9000000",
            model(index=random(3_000, "2000000000"), number=random(3_000, "2000000000")),
            "refused",
        ),
        Hostile(
            "product-27000000",
            model(index=listed(range(300)), number=listed(range(300)), distance=listed(range(300)), order="all"),
            "refused",
        ),
        Hostile(
            "condition-over-8000000",
            model(
                index=listed(range(200)),
                number=listed(range(200)),
                distance=listed(range(200)),
                pre=[wide],
                order="3",
            ),
            "refused",
        ),
        Hostile(
            "conjunction-of-equalities",
            model(
                index=listed(range(1, 8)),
                number=listed(range(1, 8)),
                distance=listed(range(0, 10)),
                pre=[conjunction],
            ),
            "survived",
        ),
        Hostile("post-and-1500", model(post=["true" + " && true" * 1_500]), "survived"),
        Hostile("post-not-2000", model(post=["!" * 2_000 + "true"]), "survived"),
        Hostile("post-unicode", model(post=["'\u202eé😀' != ''"]), "survived"),
    ]
