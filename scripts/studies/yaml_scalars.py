#!/usr/bin/python3
"""Writes test/golden/yaml_scalars.json: what roslaunch makes of scalars and documents of YAML.

roslaunch reads YAML by PyYAML, with the tags for angles that rosparam adds, and XML-RPC carries the values to the
parameter server. What one of the three cannot read or carry is "refused". Usage: yaml_scalars.py > FILE
"""
import json
import math
import xmlrpc.client

import rosparam  # adds its tags to PyYAML
import yaml

SCALARS = """
0 7 -7 +7 007 010 -010 +010 0777 08 09.5 -08 00 0_ 0_7 1_000 1__0 _1 1_ 1_000.5 0x10 -0x1F 0xfF_00 0x 0x_ 0X10 0b101
0b1_0 0b_ 0b2 0o10 1:30 -1:30 1:30:00 190:20:30 1:60 0:30 1:30.5 0:30.5 1: 1.5: 2147483647 2147483648 -2147483648
-2147483649 99999999999999999999 1.0 -1.0 +1.5 1. .5 -.5 +.5 ._5 1._5 5e3 1e3 1e+3 1E5 1.0e3 1.0e+3 1.5e-3 1.0E+5 2.87e5
2.87e+5 1e400 1.0e+400 1.0e-400 1.0e-310 00.5 010.5 -0.0 -0 1.2.3 1,5 .inf -.inf +.inf .Inf .INF .iNf .nan -.nan .NaN
.NAN inf nan Infinity true True TRUE tRUE yes Yes YES no No NO on On ON off Off OFF y n false False FALSE ~ null Null NULL
nULL word two_words point_mass = < << 2001-01-01 2001-1-1 2001-01-01T10:00:00Z 12-30 deg(10) deg(-10.5) deg(1e1) deg(010)
deg() deg(x) deg(10 Deg(10) rad(1) rad(pi) rad(pi/2) rad(2*pi/3) rad(-pi) rad(-pi/4+0.1) rad(1e-1) rad(010) rad() rad(pi/)
rad(tau) rad(pi_2) deg(10)x rad(0.1)
""".split() + [
    "", "5 kg", "deg( 10 )", "rad( pi / 2 )", "rad(2 pi)", "'010'", '"010"', "'10'", "'1e3'", "'true'", "'deg(10)'", "''",
    '"\\u00e9"', "!degrees 10", "!degrees -10.5", "!degrees deg(10)", "!degrees ' 10 '", "!degrees 010", "!degrees x",
    "!radians 1", "!radians pi/2", "!radians rad(pi/2)", "!radians (1+2)*pi", "!radians -(pi - 1)/-2", "!radians 1-2-3",
    "!radians 8/4/2", "!radians 2-3*4", "!radians ' pi '", "!radians 1.e+1", "!radians pi pi", "!radians", "!foo 1",
    "!!str 10", "!!str true", "!!int 10", '!!int "010"', "!!int 1.5", "!!float 10", "!!float 1e3", "!!float 010",
    "!!float x", "!!bool yes", "!!bool 'off'", "!!bool 1", "!!binary aGVsbG8=", "!!timestamp 2001-01-01",
    "!!python/none ~", "2001-01-01 10:00:00", "{}", "[1, 010, 1:30]",
]

DOCUMENTS = [
    "a: 1", "{a: 1, b: {c: 010}}", "rope: &rope {a: 1, b: 2}\ncable: *rope", "r: &r {a: 1, b: 2}\nc: {<<: *r}",
    "r: &r {a: 1, b: 2}\nc: {<<: *r, a: 3}", "r: &r {a: 1, b: 2}\nc: {a: 3, <<: *r}",
    "r: &r {a: 1, b: 2}\ns: &s {b: 3, c: 4}\nt: {<<: [*r, *s], c: 5}",
    "r: &r {a: 1, b: 2}\ns: &s {b: 3, c: 4}\nt: {<<: [*s, *r]}",
    "r: &r {a: 1}\ns: &s {<<: *r, b: 2}\nt: {<<: *s, c: 3}", "<<: {a: 1}\na: 2", "<<: 5", "<<: [1]", "<<: [{a: 1}, [{b: 2}]]",
    "'<<': {a: 1}", "'<<': 5", "l: [&x {a: 1}, *x, {<<: *x, b: 2}]", "1: 2", "true: 2", "~: 2", "'1': 2", "[1, 2]: 3",
    "a: ~", "a:", "a: [1, ~]", "a: !foo {b: 1}", "a: !!set {b, c}", "a: !!omap [b: 1]", "a: !!map {b: 1}", "a: !!seq [1]",
    "a: *nowhere", "a: 1\n---\nb: 2", "a: 1\n---\n", "---\na: 1\n...\n", "--- {a: 1}", "a: [1, 2", "{a:1}", "a: b: c",
    "a: {b: 2001-01-01}", "a: 'x\n  y'", "a: |\n  x\n", "# nothing but this: 1\na: 5 # five", "a: 5#3",
]


def kind(value):
    """The kind of a value, as test/robot/yaml_scalar_test.cpp calls it."""
    for name, types in (("flag", bool), ("whole", int), ("number", float), ("text", str), ("list", list), ("map", dict)):
        if isinstance(value, types):
            return name
    return "nothing" if value is None else "refused"


def written(value):
    """JSON has neither infinity nor NaN, and not everybody's JSON keeps -0."""
    if isinstance(value, float):
        return "nan" if math.isnan(value) else repr(value)
    if isinstance(value, list):
        return [written(item) for item in value]
    if isinstance(value, dict):
        return {key: written(item) for key, item in value.items()}
    return value


def carried(value):
    """Fails for what XML-RPC cannot carry."""
    sent = xmlrpc.client.dumps((value,))
    xmlrpc.client.loads(sent)
    if kind(value) == "refused":
        raise ValueError(value)
    for item in value.values() if isinstance(value, dict) else value if isinstance(value, list) else ():
        carried(item)
    return value


def row(text, read):
    """The text, what it is, and its value."""
    try:
        value = read(text)
        value = value if value is None else carried(value)
    except Exception:  # each layer has exceptions of its own
        return [text, "refused", None]
    return [text, kind(value), written(value)]


def main():
    scalars = [row(text, lambda scalar: yaml.safe_load("a: " + scalar)["a"]) for text in SCALARS]
    documents = [row(text, yaml.safe_load) for text in DOCUMENTS]
    lines = {"scalars": scalars, "documents": documents}
    print("{" + ",\n".join(json.dumps(name) + ": [\n" + ",\n".join(json.dumps(row) for row in rows) + "]"
                           for name, rows in lines.items()) + "}")


if __name__ == "__main__":
    main()
