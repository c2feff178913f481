#!/usr/bin/env python3
"""Runs what bits.tsv has digests of, compiled by every compiler and for every machine that is installed, and says which end
with the same bits.

    everywhere.py BUILD            all that is here; writes a row for each into tried.tsv beside this script
    everywhere.py BUILD --no-rows  the same without writing
    everywhere.py BUILD --quick    a few compilers, no scenes, and no row
    everywhere.py BUILD WORD...    those whose name holds a word, such as ARM64; their rows alone are written anew
    everywhere.py BUILD --scenes   the scenes alone; what else a row says stays as it was

BUILD is a folder for what is compiled. A machine of another kind is played by qemu-user, WebAssembly by node."""
import os
import platform
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

here = Path(__file__).resolve().parent
root = here.parents[1]
chapters = sorted((root / "chapters").glob("[0-9][0-9]_*"))
includes = [f"-I{folder}" for folder in [root / "common", root / "exact", root / "tools/scene_reader", *chapters]]
# As the library's own CMake target says.
always = ["-std=c++20", "-w", "-ffp-contract=off", "-fno-math-errno", "-DEIGEN_UNALIGNED_VECTORIZE=0"]
programs = {
    "rungs": [here / "rung_bits.cpp", *sorted((root / "chapters/14_hard_cases").glob("rungs_in_*.cpp"))],
    "exact solutions": [here / "exact_bits.cpp"],
    "scenes": [here / "scene_bits.cpp"],
}
scenes = [path for path in sorted((root / "tools/scenes").glob("*.json")) if path.name != "scene.schema.json"]


@dataclass
class Target:
    machine: str
    compiler: str
    flags: list
    runner: list = field(default_factory=list)
    needs: list = field(default_factory=list)  # other programs, and headers in the system's folders
    more: list = field(default_factory=list)   # sources and libraries
    with_scenes: bool = True
    is_quick: bool = False
    is_known: bool = False  # that it rounds otherwise, and the page says so

    def is_here(self):
        return all(shutil.which(need) or Path(need).exists() for need in [self.compiler, *self.runner[:1], *self.needs])

    @property
    def name(self):
        return f"{self.machine}, {self.compiler} {' '.join(self.flags)}"


def x86_targets():
    cpu = Path("/proc/cpuinfo").read_text() if Path("/proc/cpuinfo").exists() else ""
    machine = "x86-64"
    widths = [["-mavx2", "-mfma"]] if "avx2" in cpu and " fma" in cpu else []
    if "avx512f" in cpu and "avx512vl" in cpu:
        widths.append(["-mavx512f", "-mavx512vl", "-mavx512dq", "-mfma"])
    for compiler in ("g++", "clang++"):
        gcc = ["-fno-tree-slp-vectorize"] if compiler == "g++" else []
        for level in ("-O0", "-O1", "-O2", "-O3"):
            yield Target(machine, compiler, [level, *gcc],
                         is_quick=(compiler, level) in {("g++", "-O0"), ("clang++", "-O3")})
        for width in widths:
            # Clang 14 breaks off over the program of the scenes with AVX-512: "cannot select PCMPEQ".
            yield Target(machine, compiler, ["-O3", *width, *gcc], with_scenes=compiler == "g++" or width is widths[0],
                         is_quick=compiler == "clang++" and width is widths[-1])
    yield Target(machine, "clang++", ["-O2", "-stdlib=libc++"], is_quick=False)
    yield Target("x86, 32 bits", "i686-linux-gnu-g++", ["-O2", "-msse2", "-mfpmath=sse", "-fno-tree-slp-vectorize", "-static"])


def targets():
    if platform.machine() == "x86_64":
        yield from x86_targets()
    for machine, name in (("ARM64", "aarch64"), ("RISC-V", "riscv64"), ("s390x, big-endian", "s390x")):
        yield Target(machine, f"{name}-linux-gnu-g++", ["-O2", "-fno-tree-slp-vectorize", "-static"],
                     runner=[f"qemu-{name}"], more=["-latomic"] if name == "riscv64" else [])  # which swaps no byte by itself
    # WebAssembly's library has no files and no threads, which the program of the scenes needs.
    for vectors in ([], ["-msimd128", "-fno-vectorize", "-fno-slp-vectorize"], ["-msimd128"]):
        yield Target("WebAssembly", "clang++", ["--target=wasm32-wasi", "-O2", "-fexceptions", *vectors],
                     runner=["node", "--no-warnings", str(here / "run_wasm.mjs")], needs=["/usr/include/wasm32-wasi"],
                     more=[here / "no_exceptions.cpp"], with_scenes=False, is_quick=not vectors,
                     is_known=vectors == ["-msimd128"])


def known_digests():
    rows = (line.split("\t") for line in (here / "bits.tsv").read_text().splitlines())
    return {(what, precision): digest for what, precision, digest in rows}


def kind_of(what):
    return {"rung": "rungs", "exact": "exact solutions", "scene": "scenes"}[what.split()[0]]


def eigen():
    return next(([f"-isystem{folder}"] for folder in ("/usr/include/eigen3", "/usr/local/include/eigen3")
                 if Path(folder).exists()), [])


def digests(target, folder, kind):
    """What the program of that kind prints, or None where it was not compiled or broke off."""
    folder.mkdir(parents=True, exist_ok=True)
    program = folder / kind.replace(" ", "_")
    log = Path(f"{program}.log")
    json = [] if target.machine.startswith(("x86-64", "Web")) else json_headers(folder)
    with log.open("w") as said:
        command = [target.compiler, *target.flags, *always, *includes, *eigen(), *json, *map(str, programs[kind] + target.more),
                   "-o", str(program)]
        print(" ".join(command), file=said, flush=True)
        if subprocess.run(command, stdout=said, stderr=said).returncode:
            return None
        arguments = list(map(str, scenes)) if kind == "scenes" else []
        run = subprocess.run([*target.runner, str(program), *arguments], stdout=subprocess.PIPE, stderr=said, text=True)
    if run.returncode:
        return None
    return {(what, precision): digest for what, precision, digest in (line.split("\t") for line in run.stdout.splitlines())}


def json_headers(folder):
    """A cross compiler does not look into /usr/include, where the headers lie that are every machine's."""
    link = folder / "headers/nlohmann"
    if not link.is_symlink() and Path("/usr/include/nlohmann").exists():
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to("/usr/include/nlohmann")
    return [f"-isystem{link.parent}"]


def version_of(target):
    said = subprocess.run([target.compiler, "-dumpfullversion", "-dumpversion"], capture_output=True, text=True).stdout.split()
    return " ".join(["g++" if "g++" in target.compiler and "clang" not in target.compiler else "clang", *said[:1]])


def tried(target, build, known, kinds):
    """A row of the table: how many digests of each kind are the same, and which are not."""
    cells, others = [], []
    folder = build / "".join(c if c.isalnum() else "_" for c in target.name)
    for kind in programs:
        wanted = {key: digest for key, digest in known.items() if kind_of(key[0]) == kind}
        if kind not in kinds:
            cell, rules = kept(target).get(kind, ("not run", []))
            cells.append(cell)
            others += rules
            continue
        if kind == "scenes" and not target.with_scenes:
            cells.append("not run")
            continue
        found = digests(target, folder, kind)
        if found is None:
            cells.append("failed")
            others.append(f"{kind}: see {folder.name}")
            continue
        same = [key for key in wanted if found.get(key) == wanted[key]]
        cells.append(f"{len(same)} of {len(wanted)}")
        if kind != "exact solutions":  # which are known to be the library's
            others += sorted({what.split(" ", 1)[1] for what, _ in wanted.keys() - set(same)})
    return [*label(target), *cells, "; ".join(others) or "none"]


def label(target):
    """The cells that tell a row from the others."""
    flags = [flag for flag in target.flags if flag not in ("-static", "-fexceptions", "-fno-tree-slp-vectorize")]
    return [target.machine, version_of(target), " ".join(flags)]


table = here / "tried.tsv"
columns = ["machine", "compiler", "flags", "turning rules", "exact solutions", "scenes", "rules and scenes that differ"]


def kept_rows():
    return [line.split("\t") for line in table.read_text().splitlines()[1:]] if table.exists() else []


def kept(target):
    """What the table's row of this target says, by kind: the digests that are the same, and the rules that are not."""
    row = next((row for row in kept_rows() if row[:3] == label(target)), None)
    if row is None:
        return {}
    rules = [what for what in row[6].split("; ") if what != "none" and not what.startswith("scene")]
    return {kind: (cell, rules if kind == "rungs" else []) for kind, cell in zip(programs, row[3:6])}


def keep(row):
    """Writes the row into the table, in the place of an older one of the same compiler and flags."""
    rows = kept_rows()
    if row[:3] in [old[:3] for old in rows]:
        rows = [row if old[:3] == row[:3] else old for old in rows]
    else:
        rows.append(row)
    order = {tuple(label(target)): n for n, target in enumerate(targets()) if target.is_here()}
    rows.sort(key=lambda cells: order.get(tuple(cells[:3]), len(order)))
    table.write_text("".join("\t".join(cells) + "\n" for cells in [columns, *rows]))


def main():
    build, quick = Path(sys.argv[1]), "--quick" in sys.argv[2:]
    writes = not quick and "--no-rows" not in sys.argv[2:]
    asked = [word for word in sys.argv[2:] if not word.startswith("--")]
    known = known_digests()
    kinds = ["scenes"] if "--scenes" in sys.argv[2:] else [kind for kind in programs if not (quick and kind == "scenes")]
    chosen = [target for target in targets() if (target.is_quick or not quick)
              and (not asked or any(word in target.name for word in asked))]
    here_now = [target for target in chosen if target.is_here()]
    rows = []
    with ThreadPoolExecutor(int(os.environ.get("JOBS", "2"))) as pool:
        for target, row in zip(here_now, pool.map(lambda target: tried(target, build, known, kinds), here_now)):
            print(" | ".join(row), flush=True)
            if not target.is_known:
                rows.append(row)
            if writes:
                keep(row)
    for target in chosen:
        if not target.is_here():
            print(f"not here: {target.name}")
    # The exact solutions ask the C++ library, whose sines are every library's own.
    rounds_otherwise = [row for row in rows if "failed" in row or any(
        cell != "not run" and len(set(cell.split(" of "))) > 1 for cell in (row[3], row[5]))]
    return 1 if rounds_otherwise else 0


if __name__ == "__main__":
    sys.exit(main())
