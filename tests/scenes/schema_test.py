"""schema_test.py PRINT_KEYS SCENES: the published schema and the loader know the same keys, with the same units, and
the same turning methods, of which a build without Boost lacks the exact solution; every shipped scene is valid; and the schema refuses what it should."""
import copy
import json
import pathlib
import subprocess
import sys

from jsonschema import Draft202012Validator

program, scenes = sys.argv[1], pathlib.Path(sys.argv[2])
schema = json.loads((scenes / "scene.schema.json").read_text())
failures = []


def verify(fact, sentence):
    if not fact:
        failures.append(sentence)


def resolved(part):
    """A property with what it refers to."""
    target = schema["$defs"][part["$ref"].rsplit("/", 1)[1]] if "$ref" in part else {}
    return {**target, **part}


Draft202012Validator.check_schema(schema)

loader, methods, schemes = {}, [], []
for line in subprocess.run([program], check=True, capture_output=True, text=True).stdout.splitlines():
    if "\t" not in line:
        (schemes if line.startswith("scheme ") else methods).append(line.removeprefix("scheme "))
        continue
    kind, key, unit, required = line.split("\t")
    loader.setdefault(kind, {})[key] = (unit, required != "")

published = {name: part for name, part in schema["$defs"].items() if "properties" in part}
verify(set(loader) == set(published), f"objects differ: {set(loader) ^ set(published)}")
for kind in set(loader) & set(published):
    properties = published[kind]["properties"]
    verify(set(properties) == set(loader[kind]), f"keys of {kind} differ: {set(properties) ^ set(loader[kind])}")
    verify(published[kind].get("additionalProperties") is False, f"{kind} lets unknown keys pass")
    needed = {key for key, (_, required) in loader[kind].items() if required}
    verify(set(published[kind].get("required", [])) == needed, f"{kind} requires other keys")
    for key in set(properties) & set(loader[kind]):
        description = resolved(properties[key]).get("description", "")
        unit = loader[kind][key][0]
        verify(description or "const" in properties[key], f"{kind}.{key} has no description")
        words = description.replace(",", " ").replace(";", " ").replace(":", " ").replace(". ", " ").rstrip(".") + " "
        verify(not unit or f" {unit} " in " " + words, f"the description of {kind}.{key} lacks the unit {unit}")

published_methods = published["scene"]["properties"]["turning_method"]["enum"]
if "exact_solution" not in methods:
    methods.append("exact_solution")
verify(published_methods == methods, f"turning methods differ: {published_methods}, {methods}")
published_schemes = published["scene"]["properties"]["scheme"]["enum"]
verify(published_schemes == schemes, f"schemes differ: {published_schemes}, {schemes}")

validator = Draft202012Validator(schema)
shipped = sorted(path for path in scenes.glob("*.json") if path.name != "scene.schema.json")
verify(len(shipped) >= 12, "fewer than twelve scenes")
for path in shipped:
    for error in validator.iter_errors(json.loads(path.read_text())):
        failures.append(f"{path.name}: {error.json_path}: {error.message[:200]}")

# A schema that lets everything pass would have passed so far.
good = json.loads((scenes / "everything.json").read_text())
for mistake in (
    lambda scene: scene.pop("duration"),
    lambda scene: scene.update(gravity=9.81),
    lambda scene: scene.update(duration=0),
    lambda scene: scene.update(turning_method="magic"),
    lambda scene: scene.update(scheme="velvet"),
    lambda scene: scene["bodies"][2].update(mass=-1),
    lambda scene: scene["bodies"][2].update(colour="red"),
    lambda scene: scene["bodies"][3]["solid"].update(shape="spere"),
    lambda scene: scene["bodies"][3]["solid"].update(height=1),
    lambda scene: scene["bodies"][3].update(position=[1, 2]),
    lambda scene: scene["effects"][0].update(kind="gravty"),
    lambda scene: scene["effects"][0].pop("acceleration"),
    lambda scene: scene["effects"][8].update(rate=1),
):
    bad = copy.deepcopy(good)
    mistake(bad)
    verify(not validator.is_valid(bad), "a scene with a mistake is valid")

for failure in failures:
    print(f"error: {failure}")
print(f"{len(shipped)} scenes, {sum(map(len, loader.values()))} keys")
sys.exit(1 if failures else 0)
