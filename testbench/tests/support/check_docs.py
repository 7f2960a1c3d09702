"""check_docs.py [--write]: what the documents say against where it comes from.

Between two marker lines, `<!-- printed by check_docs.py: NAME -->` and
`<!-- end of what is printed -->`, stands text that this prints:

  registers   docs/platform.md   offsets of tlm/platform/registers.h
  example     docs/platform.md   cmake/tests/package/main.cpp
  profiles    docs/numbers.md    `repousse info` for each shipped profile
  functions   docs/numbers.md    errors that reciprocal_test and inverse_sqrt_test measure

Without --write a difference is named and ends with status 1. It also checks that links between
documents lead somewhere, and that docs/report.md names every field of report.schema.json. Runs in
the repository's root; REPOUSSE_PROGRAM and REPOUSSE_BUILD_DIR say where the programs are.
"""

import json
import os
import re
import subprocess
import sys
from pathlib import Path

END = "<!-- end of what is printed -->"
SCENE = "scenes/donut_small.toml"


def output(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def register_offsets():
    """Byte offset of each register, by name, in order."""
    text = Path("tlm/platform/registers.h").read_text()
    body = re.search(r"enum Register : uint32_t \{(.*?)\n\};", text, re.S).group(1)
    index, at = 0, {}
    for name, base, plus in re.findall(r"^ *(k\w+)(?: = (k\w+)(?: \+ (\d+))?)?,", body, re.M):
        if base:
            index = at[base] + int(plus or 0)
        at[name] = index
        index += 1
    return {n: 4 * i for n, i in at.items() if n not in {"kFrameEnd", "kRegisterCount"}}


def print_registers(old):
    """The table as it is, with its offsets; every register must have its row."""
    offsets = register_offsets()
    rows = re.findall(r"^\| `0x\w+` \| `(k\w+)` \|", old, re.M)
    if rows != list(offsets):
        raise SystemExit(f"docs/platform.md: rows {rows}, expected {list(offsets)}")
    return re.sub(
        r"^\| `0x\w+` \| `(k\w+)` \|",
        lambda m: f"| `0x{offsets[m[1]]:02x}` | `{m[1]}` |",
        old,
        flags=re.M,
    )


def print_example(_):
    return "```cpp\n" + Path("cmake/tests/package/main.cpp").read_text() + "```\n"


def profile_rows(name):
    lines = output(os.environ["REPOUSSE_PROGRAM"], "info", SCENE, "--profile", name).splitlines()
    table = lines[lines.index(f'profile "{name}"') + 1 :]
    return [(line[2:28].strip(), line[29:53].strip(), line[54:]) for line in table if line[:2] == "  "]


def print_profiles(_):
    text = "\n| key | `default` | `narrow` | what |\n|---|---|---|---|\n"
    for (key, value, what), (_, narrow, _) in zip(profile_rows("default"), profile_rows("narrow")):
        text += f"| `{key}` | `{value}` | `{narrow}` | {what} |\n"
    return text + "\n"


def print_functions(_):
    tests = os.environ["REPOUSSE_BUILD_DIR"] + "/tests/"
    names = ("reciprocal_test", "inverse_sqrt_test")
    measured = "".join(output(tests + name, "--gtest_filter=*Errs*:*Shows*") for name in names)
    text = "\n| function | table | Newton steps | mantissa | converged | x < 2^18 | x of 24 to 31 bits |\n"
    text += "|---|---|---|---|---|---|---|\n"
    row = r"^(1/\S+) +index +(\d+), Newton (\d+), mantissa (\d+)( \(not converged\))?: (\S+) for.*?, (\S+) for"
    for f in re.findall(row, measured, re.M):
        function, index, steps, bits, diverged, small, large = f
        yes = "no" if diverged else "yes"
        text += f"| {function} | 2^{index} | {steps} | {bits} bits | {yes} | {small} | {large} |\n"
    return text + "\n"


PRINTED = {
    "docs/platform.md": {"registers": print_registers, "example": print_example},
    "docs/numbers.md": {"profiles": print_profiles, "functions": print_functions},
}


def stale_places(write):
    for name, places in PRINTED.items():
        text = Path(name).read_text()
        for place, printer in places.items():
            begin = f"<!-- printed by check_docs.py: {place} -->\n"
            head, rest = text.split(begin)
            old, tail = rest.split(END, 1)
            new = printer(old)
            if new != old:
                yield f"{name}: {place} is stale; run check_docs.py --write"
            text = head + begin + new + END + tail
        if write:
            Path(name).write_text(text)


def broken_links():
    for page in [Path("CONTRIBUTING.md"), *sorted(Path("docs").rglob("*.md"))]:
        for target in re.findall(r"\]\(([^)#:]+)(?:#[^)]*)?\)", page.read_text()):
            if not (page.parent / target).exists():
                yield f"{page}: {target} is not there"


def undocumented_fields():
    text = Path("docs/report.md").read_text()
    named = {part for code in re.findall(r"`([\w.]+)`", text) for part in code.split(".")}
    profile = set()

    def walk(schema):
        for name, inner in schema.get("properties", {}).items():
            if name == "entries":
                profile.update(inner["properties"])
                yield name
                continue
            yield name
            yield from walk(inner) if isinstance(inner, dict) else ()
        for inner in schema.get("$defs", {}).values():
            yield from walk(inner)

    schema = json.loads(Path("docs/report.schema.json").read_text())
    for field in sorted(set(walk(schema)) - named):
        yield f"docs/report.md: the field {field} is not explained"
    numbers = Path("docs/numbers.md").read_text()
    for key in sorted(k for k in profile if f"| `{k}` |" not in numbers):
        yield f"docs/numbers.md: the profile entry {key} is not listed"


def main():
    write = sys.argv[1:] == ["--write"]
    stale = list(stale_places(write))
    problems = [] if write else stale
    problems += [*broken_links(), *undocumented_fields()]
    print("\n".join(problems) or "the documents are as they should be")
    sys.exit(1 if problems else 0)


if __name__ == "__main__":
    main()
