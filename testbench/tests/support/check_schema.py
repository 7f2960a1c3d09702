"""check_schema.py SCHEMA FILE...: whether JSON files obey a JSON Schema.

It knows the part of JSON Schema 2020-12 that docs/report.schema.json uses, and refuses a schema
with any other keyword, so that nothing in a schema is silently without effect. Prints a line for
each violation, `FILE: $.path: what is wrong`, and ends with status 1 if there is one.
"""

import json
import re
import sys

ANNOTATIONS = {"$schema", "$defs", "title", "description"}
TYPES = {"object": dict, "array": list, "string": str, "boolean": bool, "number": (int, float)}


def has_type(value, name):
    """JSON's types: a boolean is no number, and 1.0 is an integer."""
    if name == "integer":
        return has_type(value, "number") and value == int(value)
    return isinstance(value, TYPES[name]) and (name == "boolean" or not isinstance(value, bool))


def same(a, b):
    return type(a) is type(b) and a == b


class Validator:
    def __init__(self, schema):
        self.root = schema

    def resolve(self, reference):
        schema = self.root
        for part in reference.removeprefix("#/").split("/"):
            schema = schema[part]
        return schema

    def errors(self, value, schema, path="$"):
        """All violations of `schema` by `value`, as texts."""
        if isinstance(schema, bool):
            return [] if schema else [f"{path}: must not be there"]
        found = []
        for keyword, operand in schema.items():
            if keyword in ANNOTATIONS or keyword in {"then", "else"}:
                continue
            check = getattr(self, "check_" + keyword.removeprefix("$"), None)
            if check is None:
                raise SystemExit(f"check_schema: the keyword {keyword} is not known")
            found += check(value, operand, schema, path)
        return found

    def check_ref(self, value, operand, _, path):
        return self.errors(value, self.resolve(operand), path)

    def check_type(self, value, operand, _, path):
        return [] if has_type(value, operand) else [f"{path}: {value!r} is not of type {operand}"]

    def check_const(self, value, operand, _, path):
        return [] if same(value, operand) else [f"{path}: {value!r}, expected {operand!r}"]

    def check_enum(self, value, operand, _, path):
        if any(same(value, other) for other in operand):
            return []
        return [f"{path}: {value!r}, expected one of {operand}"]

    def check_pattern(self, value, operand, _, path):
        if not isinstance(value, str) or re.search(operand, value):
            return []
        return [f"{path}: {value!r} does not match {operand}"]

    def check_minLength(self, value, operand, _, path):
        short = isinstance(value, str) and len(value) < operand
        return [f"{path}: {value!r} is shorter than {operand}"] if short else []

    def bound(self, value, path, broken, text):
        return [f"{path}: {value} is {text}"] if has_type(value, "number") and broken(value) else []

    def check_minimum(self, value, operand, _, path):
        return self.bound(value, path, lambda v: v < operand, f"less than {operand}")

    def check_exclusiveMinimum(self, value, operand, _, path):
        return self.bound(value, path, lambda v: v <= operand, f"not more than {operand}")

    def check_maximum(self, value, operand, _, path):
        return self.bound(value, path, lambda v: v > operand, f"more than {operand}")

    def check_minItems(self, value, operand, _, path):
        few = isinstance(value, list) and len(value) < operand
        return [f"{path}: fewer than {operand} items"] if few else []

    def check_maxItems(self, value, operand, _, path):
        many = isinstance(value, list) and len(value) > operand
        return [f"{path}: more than {operand} items"] if many else []

    def check_items(self, value, operand, _, path):
        if not isinstance(value, list):
            return []
        return [e for i, v in enumerate(value) for e in self.errors(v, operand, f"{path}[{i}]")]

    def check_required(self, value, operand, _, path):
        if not isinstance(value, dict):
            return []
        return [f"{path}.{name}: is missing" for name in operand if name not in value]

    def check_properties(self, value, operand, _, path):
        if not isinstance(value, dict):
            return []
        return [
            error
            for name, schema in operand.items()
            if name in value
            for error in self.errors(value[name], schema, f"{path}.{name}")
        ]

    def check_additionalProperties(self, value, operand, schema, path):
        if not isinstance(value, dict):
            return []
        rest = [name for name in value if name not in schema.get("properties", {})]
        return [e for n in rest for e in self.errors(value[n], operand, f"{path}.{n}")]

    def check_oneOf(self, value, operand, _, path):
        results = [self.errors(value, schema, path) for schema in operand]
        if sum(not result for result in results) == 1:
            return []
        nearest = max(results, key=lambda result: min((len(e) for e in result), default=0))
        return [f"{path}: fits {sum(not r for r in results)} of {len(operand)} kinds"] + nearest

    def check_if(self, value, operand, schema, path):
        branch = "else" if self.errors(value, operand, path) else "then"
        return self.errors(value, schema.get(branch, True), path)


def main():
    if len(sys.argv) < 3:
        raise SystemExit("usage: check_schema.py SCHEMA FILE...")
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    failed = False
    for name in sys.argv[2:]:
        with open(name, encoding="utf-8") as file:
            errors = Validator(schema).errors(json.load(file), schema)
        for error in errors:
            print(f"{name}: {error}")
        failed |= bool(errors)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
