#!/usr/bin/env python3
"""burns_test.py ADVISE SIMULATE SCRATCH: what advise confirms of bodies that short burns turn holds against the closed form.

A burn of 1 to 50 ms turns a box about a principal axis, so its angle is known: α t²/2 while the burn lasts, and then it grows evenly.
No other part of the project decides here which angle is right."""
import csv
import json
import math
import random
import subprocess
import sys
from pathlib import Path

advise, simulate, scratch = sys.argv[1], sys.argv[2], Path(sys.argv[3])
wanted, seconds = 0.01, 2


def scene(force, begin, duration, rate):
    return {"title": "A burn", "step": {"per_second": rate}, "duration": seconds,
            "bodies": [{"name": "box", "solid": {"shape": "box", "size": [1, 1, 1]}, "mass": 1}],
            "effects": [{"kind": "thruster", "bodies": ["box"], "force": [force, 0, 0], "point": [0, 0.1, 0],
                         "from": begin, "until": begin + duration}]}


def angle_at(time, force, begin, duration):
    """About −z, for the force along x acts at y = 0.1 m. A cube of 1 kg and 1 m has the moment 1/6 kg m²."""
    acceleration, burnt = force * 0.1 * 6, min(max(time - begin, 0), duration)
    return acceleration * burnt * (burnt / 2 + max(time - begin - duration, 0))


def worst_error(promise, burn, path):
    """Of the run that was promised, at each of its sixty states a second."""
    rate = promise["steps_per_second"]
    path.write_text(json.dumps(scene(*burn, rate)))
    table = path.with_suffix(".csv")
    chosen = [word for key in ("method", "scheme", "precision") if promise[key] for word in (f"--{key}", promise[key])]
    subprocess.run([simulate, path, *chosen, "--every", str(rate // 60), "--csv", table], check=True, stdout=subprocess.DEVNULL)
    worst = 0.0
    with table.open() as rows:
        for row in csv.DictReader(rows):
            angle = -2 * math.atan2(float(row["orientation z"]), float(row["orientation w"]))
            worst = max(worst, abs(math.remainder(angle - angle_at(float(row["time (s)"]), *burn), 2 * math.pi)))
    return worst


def main():
    scratch.mkdir(parents=True, exist_ok=True)
    draw, confirmed, broken = random.Random(24), 0, []
    burns = [(250, 1.0, 0.004)] + [(draw.uniform(5, 50), draw.uniform(0.5, 1.5), draw.uniform(0.001, 0.05)) for _ in range(23)]
    for number, burn in enumerate(burns):
        path = scratch / f"burn {number}.json"
        path.write_text(json.dumps(scene(*burn, 60)))
        said = subprocess.run([advise, path, "--for", str(seconds), "--angle", str(wanted), "--precision", "double", "--json"],
                              stdout=subprocess.PIPE, text=True)
        answer = json.loads(said.stdout)
        if not answer["confirmed"]:
            continue
        confirmed += 1
        error = worst_error(answer["cheapest"], burn, path)
        if error > wanted:
            broken.append(f"a burn of {burn[0]:.1f} N from {burn[1]} s for {burn[2]} s: {error:.3g} rad, confirmed to be at most {wanted} rad")
    print(f"{confirmed} of {len(burns)} burns confirmed", *broken, sep="\n")
    return 1 if broken or not confirmed else 0


if __name__ == "__main__":
    sys.exit(main())
